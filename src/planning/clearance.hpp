// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>

#include "base/work.hpp"
#include "grid/grid.hpp"

namespace meander {

/// How far from the solid cells and the rim of a grid, exactly: cells are squares. In units of cells.
class Clearance {
 public:
  explicit Clearance(const Grid<std::uint8_t>& solid, const Work& work = {});

  /// From every point of the straight piece, at least; 0 where it touches something solid or the rim, -1 where it goes
  /// through one. Answers above `enough` may be too small or too large, but not below it.
  double of(const Vec2& from, const Vec2& to, double enough = 1e9) const;
  double of(const Vec2& point) const { return of(point, point); }

 private:
  double of_short_piece(const Vec2& from, const Vec2& to, double enough) const;
  double of_row(const Vec2& from, const Vec2& to, int row, double least) const;

  int width_, height_;
  /// Of every cell: the nearest solid column of its row, at or left of it, and at or right of it; the rim is solid.
  Grid<std::int32_t> left_, right_;
};

/// From a straight piece to the unit square whose lower left corner is (x, y); -1 when it goes through it.
double distance_to_square(const Vec2& from, const Vec2& to, double x, double y);

}  // namespace meander
