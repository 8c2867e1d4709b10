// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/work.hpp"
#include "world/import_result.hpp"

namespace meander {

/// Is this the text of a line map of ARIA and MobileSim? Both they and MovingAI's maps are called .map.
bool is_aria_map(const std::string& text);

/// The walls of such a map: the ends of each line after LINES, in millimetres. A RobotHome is the start, a Goal a
/// place; what the robot scanned (DATA) is left out. Throws FileError.
Imported aria_from_text(const std::string& text, const std::string& path, const Work& work = {});

}  // namespace meander
