// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cmath>

#include "geometry/shapes.hpp"

namespace meander {

/// Square cells over part of the plane. Sides are powers of two and corners multiples of them, so that the coordinates
/// of cell borders are exact.
struct CellFrame {
  double side = 1;
  Vec2 low{0, 0};
  int columns = 3;
  int rows = 3;

  /// May lie outside; call only with positions within a few times kFarthest.
  int column(double x) const { return static_cast<int>(std::floor((x - low.x()) / side)); }
  int row(double y) const { return static_cast<int>(std::floor((y - low.y()) / side)); }
  int nearest_column(double x) const { return static_cast<int>(std::clamp((x - low.x()) / side, 0.0, columns - 1.0)); }
  int nearest_row(double y) const { return static_cast<int>(std::clamp((y - low.y()) / side, 0.0, rows - 1.0)); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  Vec2 high() const { return low + side * Vec2(columns, rows); }
  Vec2 center(int column, int row) const { return low + side * Vec2(column + 0.5, row + 0.5); }

  /// What a piece is thickened by before it is put into cells [m]: far above the rounding of any ray's way through the
  /// cells, so that a ray never passes a piece between two cells.
  double slack() const { return 1e-6 * side; }

  /// Is the box in the grid, at least a cell away from its rim?
  bool holds(const Box& box) const {
    const Vec2 margin(side, side);
    const Box inner{low + margin, high() - margin};
    return inner.contains(box.low) && inner.contains(box.high);
  }
};

/// Calls visit(cell index) for every cell that the wall a-b touches; the frame covers the wall.
template <class Visit>
void for_each_cell(const CellFrame& frame, const Vec2& a, const Vec2& b, Visit visit) {
  const double slack = frame.slack();
  const Vec2 d = b - a;
  const int top = frame.row(std::max(a.y(), b.y()) + slack);
  for (int row = frame.row(std::min(a.y(), b.y()) - slack); row <= top; ++row) {
    double t0 = 0, t1 = 1;  // the part of the wall within the row
    if (d.y() != 0) {
      const double y = frame.low.y() + row * frame.side;
      t0 = std::clamp((y - slack - a.y()) / d.y(), 0.0, 1.0);
      t1 = std::clamp((y + frame.side + slack - a.y()) / d.y(), 0.0, 1.0);
    }
    const double x0 = a.x() + t0 * d.x(), x1 = a.x() + t1 * d.x();
    const int last = frame.column(std::max(x0, x1) + slack);
    for (int column = frame.column(std::min(x0, x1) - slack); column <= last; ++column) visit(frame.index(column, row));
  }
}

/// Calls visit(cell index) for every cell that the disc touches; the frame covers the disc.
template <class Visit>
void for_each_cell(const CellFrame& frame, const Disc& disc, Visit visit) {
  const double reach = disc.radius + frame.slack();
  const Vec2 c = disc.center;
  const int top = frame.row(c.y() + reach);
  for (int row = frame.row(c.y() - reach); row <= top; ++row) {
    const double y = frame.low.y() + row * frame.side;
    const double off = std::max({0.0, y - c.y(), c.y() - (y + frame.side)});
    const double half_chord = std::sqrt(std::max(0.0, reach * reach - off * off)) + frame.slack();
    const int last = std::min(frame.columns - 1, frame.column(c.x() + half_chord));
    for (int column = std::max(0, frame.column(c.x() - half_chord)); column <= last; ++column)
      visit(frame.index(column, row));
  }
}

}  // namespace meander
