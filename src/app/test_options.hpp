// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "app/command_line.hpp"
#include "app/test_run.hpp"

namespace meander {

/// Reads what stands behind `meander test`. --help prints and gives an exit code at once, as does a mistake.
std::optional<int> parse_test_options(const CommandLine& line, TestOptions& options);

}  // namespace meander
