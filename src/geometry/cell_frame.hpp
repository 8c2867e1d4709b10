// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/shapes.hpp"

namespace meander {

/// Square cells over part of the plane. Sides are powers of two and corners multiples of them, so that the coordinates
/// of cell borders are exact.
struct CellFrame {
  CellFrame(double side, const Vec2& low, int columns, int rows)
      : side(side), per_metre(1 / side), low(low), columns(columns), rows(rows) {}

  double side;
  double per_metre;  ///< cells
  Vec2 low;
  int columns;
  int rows;

  /// Of a position in the frame. (Truncation: rounding down takes a call on basic processors.)
  int column(double x) const { return static_cast<int>((x - low.x()) * per_metre); }
  int row(double y) const { return static_cast<int>((y - low.y()) * per_metre); }
  /// Of any position.
  int nearest_column(double x) const {
    return static_cast<int>(std::clamp((x - low.x()) * per_metre, 0.0, columns - 1.0));
  }
  int nearest_row(double y) const { return static_cast<int>(std::clamp((y - low.y()) * per_metre, 0.0, rows - 1.0)); }
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

/// Calls visit(column, row, t0, t1) for every cell that the wall a-b touches, where a + t * (b - a), t0 <= t <= t1, is
/// the part of it in the cell. The frame holds the wall.
template <class Visit>
void for_each_cell(const CellFrame& frame, const Vec2& a, const Vec2& b, Visit visit) {
  struct Part {
    double t0, t1;
  };
  const double slack = frame.slack();
  const Vec2 d = b - a;
  const double per_x = d.x() != 0 ? 1 / d.x() : 0, per_y = d.y() != 0 ? 1 / d.y() : 0;
  const auto between = [slack](double low, double high, double start, double per_metre, Part part) {
    if (per_metre == 0) return part;  // parallel to the border, so it does not leave
    double enter = (low - slack - start) * per_metre, leave = (high + slack - start) * per_metre;
    if (per_metre < 0) std::swap(enter, leave);
    return Part{std::clamp(enter, part.t0, part.t1), std::clamp(leave, part.t0, part.t1)};
  };
  const int top = frame.row(std::max(a.y(), b.y()) + slack);
  for (int row = frame.row(std::min(a.y(), b.y()) - slack); row <= top; ++row) {
    const double y = frame.low.y() + row * frame.side;
    const Part in_row = between(y, y + frame.side, a.y(), per_y, {0, 1});
    const double x0 = a.x() + in_row.t0 * d.x(), x1 = a.x() + in_row.t1 * d.x();
    const int last = frame.column(std::max(x0, x1) + slack);
    for (int column = frame.column(std::min(x0, x1) - slack); column <= last; ++column) {
      const double x = frame.low.x() + column * frame.side;
      const Part in_cell = between(x, x + frame.side, a.x(), per_x, in_row);
      visit(column, row, in_cell.t0, in_cell.t1);
    }
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
