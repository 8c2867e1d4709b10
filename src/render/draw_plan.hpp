// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/plan.hpp"
#include "render/draw_list.hpp"
#include "render/theme.hpp"

namespace meander {

/// The map: what is solid, and how hard the rest is.
DrawList draw_planning_map(const PlanningMap& map, const Theme& theme);

/// The landscape on the scale on which paths are found (ln v of neural maps and harmonic functions, else the cost),
/// with contours a tenth of its range apart; what the robot's centre must keep out of; start, targets, and the path.
DrawList draw_plan(const Plan& plan, const Theme& theme);

}  // namespace meander
