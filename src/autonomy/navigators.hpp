// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "robot/contracts.hpp"
#include "robot/platform.hpp"

namespace meander {

/// A new navigator with its default options for this platform; throws ArgumentError that lists the known names.
Navigator navigator_by_name(const std::string& name, const Platform& platform);
std::vector<std::string> navigator_names();

}  // namespace meander
