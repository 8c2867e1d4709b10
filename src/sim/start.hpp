// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "sim/sim_robot.hpp"
#include "world/world.hpp"

namespace meander {

/// Where the robots start. Throws ArgumentError saying which robot, where and why when an option is out of range, there
/// is no start, or it is not finite, outside the bounds, in or too near an obstacle, a mover or another robot.
std::vector<Pose2> checked_starts(const World& world, const std::vector<RobotOptions>& robots);

}  // namespace meander
