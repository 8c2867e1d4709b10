// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "base/work.hpp"
#include "grid/grid.hpp"

namespace meander {

/// A closed walk along the edges of cells with the solid on the left. Corner (x, y) is the lower left one of cell (x,
/// y).
struct Outline {
  enum class Heading : std::uint8_t { east, north, west, south };
  /// Along one edge of a cell.
  struct Step {
    Cell from;  ///< the corner where it begins
    Heading heading;
    int turn = 0;          ///< at `from`: 1 left, -1 right, 0 straight on
    bool pinched = false;  ///< `from` joins two solid cells that touch nowhere else
  };
  std::vector<Step> steps;
  bool hole = false;            ///< goes round a free area
  Cell inside;                  ///< a solid cell beside the walk
  std::int64_t area_cells = 0;  ///< enclosed cells; negative for holes
};

/// Hands over the outlines of all cells that are not 0, in the order of their lowest, then leftmost step to the east.
/// Solid cells that touch in a corner are joined there.
void walk_outlines(const Grid<std::uint8_t>& solid, const Work& work, const std::function<void(const Outline&)>& take);

/// The corners [cells] of a ring with few edges that crosses each step of the outline, in order, within `epsilon`
/// [cells] of its middle and never leaves the squares between four neighbouring cell centres that the outline runs
/// through. So the ring keeps every cell centre on its side, and rings of the same raster cannot meet. Right angles
/// stay exact.
std::vector<Vec2> straightened(const Outline& outline, double epsilon);

}  // namespace meander
