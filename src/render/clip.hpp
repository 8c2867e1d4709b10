// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "geometry/shapes.hpp"

namespace meander {

/// The part of a filled ring inside the box (Sutherland and Hodgman 1974); empty when there is none. Edges that run
/// along the rim of the box may be added.
std::vector<Vec2> clipped_ring(std::vector<Vec2> ring, const Box& box);

/// The parts of a run of points inside the box (Liang and Barsky 1984), in order.
std::vector<Ring> clipped_line(const std::vector<Vec2>& points, bool closed, const Box& box);

/// Corners of a polygon that stays within a tenth of a unit of a circle whose radius is `radius_units`.
std::vector<Vec2> circle(const Disc& disc, double radius_units);

}  // namespace meander
