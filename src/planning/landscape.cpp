// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/landscape.hpp"

#include <algorithm>

namespace meander {
namespace {

/// Leads a step from the cell to a higher value?
bool leads_up(const PlanningProblem& problem, const Grid<double>& value, Cell cell) {
  for (const LatticeStep& step : lattice_steps(problem.lattice, cell.y))
    if (value.at({cell.x + step.dx, cell.y + step.dy}, kNoValue) > value[cell] &&
        open_step(problem.blocked, problem.corners, cell, step))
      return true;
  return false;
}

}  // namespace

std::int64_t dead_units(const PlanningProblem& problem, const Grid<double>& value, const Work& work) {
  const int width = value.width(), height = value.height();
  std::int64_t dead = 0;
  for (int y = 0; y < height; ++y) {
    work.poll();
    const double* row = &value[{0, y}];
    const double* below = &value[{0, std::max(y - 1, 0)}];
    const double* above = &value[{0, std::min(y + 1, height - 1)}];
    for (int x = 0; x < width; ++x) {
      const double own = row[x];
      // Nearly every cell has a higher one straight beside it, on every lattice, and nothing between them.
      const bool up = (below[x] > own) | (above[x] > own) | (row[std::max(x - 1, 0)] > own) |
                      (row[std::min(x + 1, width - 1)] > own);
      if ((up && own != kNoValue) || problem.blocked[{x, y}] != 0 || own == 0) continue;  // 0: a target
      if (leads_up(problem, value, {x, y}) == (own == kNoValue)) ++dead;
    }
  }
  return dead;
}

}  // namespace meander
