// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>

#include "geometry/vec.hpp"

namespace meander {

/// Where the cells of a raster are, seen from a robot, row after row: range from its centre [m], to within 1e-6 of it,
/// and bearing from its heading, in [-2 pi, 2 pi], to within 3e-6. `first` is the centre of the first cell, seen from
/// the robot's centre in the axes of the raster [m]; `heading` is in (-pi, pi] in the same axes. Same bits everywhere.
void cell_places(const Vec2& first, double cell, int columns, int rows, double heading, std::span<float> range,
                 std::span<float> bearing);

}  // namespace meander
