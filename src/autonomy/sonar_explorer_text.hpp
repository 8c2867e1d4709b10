// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "autonomy/sonar_explorer.hpp"

namespace meander {

/// All that a sonar explorer knows from run to run: goal, options, robot, map and graph. Reading it gives an explorer
/// whose next runs are those of the one that was written, to the last bit.
std::string to_text(const SonarExplorer& explorer);
/// Throws FileError "path:line: what is wrong".
std::shared_ptr<SonarExplorer> sonar_explorer_from_text(const std::string& text, const std::string& path = "text");

void write_sonar_explorer(const SonarExplorer& explorer, const std::string& path);
std::shared_ptr<SonarExplorer> read_sonar_explorer(const std::string& path);

}  // namespace meander
