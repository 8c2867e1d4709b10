// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdlib>

#include "grid/grid.hpp"

namespace meander {

/// Calls visit(cell) for the cells that the segment passes, in order, both ends' cells included, until visit returns
/// false; says whether it came to the end. Through the common corner of four cells it goes diagonally. Cells may lie
/// outside the grid.
template <class Visit>
bool traverse(const GridFrame& frame, const Vec2& from, const Vec2& to, Visit visit) {
  const Vec2 start = frame.in_cells(from), way = frame.in_cells(to) - start;
  const Cell last = frame.cell(to);
  Cell cell = frame.cell(from);
  const Cell step{last.x < cell.x ? -1 : 1, last.y < cell.y ? -1 : 1};
  while (true) {
    if (!visit(cell)) return false;
    if (cell == last) return true;
    // How far to the next border of either axis, as shares of the way brought to the same denominator.
    const double x = std::abs(cell.x + (step.x > 0) - start.x()) * std::abs(way.y());
    const double y = std::abs(cell.y + (step.y > 0) - start.y()) * std::abs(way.x());
    const bool across = cell.x != last.x && (x <= y || cell.y == last.y);
    const bool up = cell.y != last.y && (y <= x || cell.x == last.x);
    if (across) cell.x += step.x;
    if (up) cell.y += step.y;
  }
}

}  // namespace meander
