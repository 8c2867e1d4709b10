// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/clearance.hpp"

namespace meander {

/// What a path is like. Lengths in cells.
struct PathMeasures {
  double length = 0;
  double turning = 0;         ///< sum of |change of direction| [rad]
  double curvature = 0;       ///< largest, by directions a cell of length apart [rad/cell]
  double clearance_mean = 0;  ///< along the way; from the nearest solid cell or the rim
  double clearance_min = 0;   ///< exactly, of all points; below 0: the path goes through something
};

PathMeasures measure_path(const std::vector<Vec2>& points, const Clearance& clearance, const Work& work = {});

/// Is every point of the path at least the radius [cells] away from all that is solid? Exactly, to 1e-9 cells.
bool certified(const PathMeasures& measures, double radius);

/// The path's points every `spacing` of its length, both ends included.
std::vector<Vec2> resampled(const std::vector<Vec2>& points, double spacing);

}  // namespace meander
