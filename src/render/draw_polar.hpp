// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "polar/polar_navigator.hpp"
#include "render/draw_list.hpp"
#include "render/draw_scan.hpp"

namespace meander {

/// A cycle of a polar navigator: readings, memory, obstructed units, activation (lighter the nearer to the target), the
/// subgoal and the trajectory chosen. In the odometry frame, as large as the map. Throws ArgumentError before the first
/// cycle.
DrawList draw_polar(const PolarNavigator& navigator, const RobotLook& look);

}  // namespace meander
