// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/theta_star.hpp"

#include <cstdlib>

#include "planning/clearance.hpp"
#include "planning/graph_search.hpp"

namespace meander {
namespace {

/// Where a robot may go straight from cell to cell: past free cells, and with its whole body where it has any extent.
class Sight {
 public:
  explicit Sight(const PlanningProblem& problem) : problem_(problem) {
    if (problem.robot_radius > 0) clearance_.emplace(problem.solid());
  }
  bool operator()(Cell from, Cell to) const {
    if (!line_of_sight(problem_.blocked, problem_.corners, from, to)) return false;
    if (!clearance_) return true;
    const double radius = problem_.robot_radius;
    return clearance_->of(cell_center(problem_.lattice, from), cell_center(problem_.lattice, to), radius) >= radius;
  }

 private:
  const PlanningProblem& problem_;
  std::optional<Clearance> clearance_;
};

double distance(Cell a, Cell b) { return Vec2(b.x - a.x, b.y - a.y).norm(); }

}  // namespace

bool line_of_sight(const Grid<std::uint8_t>& blocked, Corners corners, Cell from, Cell to) {
  const int dx = std::abs(to.x - from.x), dy = std::abs(to.y - from.y);
  const int right = to.x > from.x ? 1 : -1, up = to.y > from.y ? 1 : -1;
  int ahead = dx - dy;  // which side of a cell the line leaves by, in whole numbers: > 0 left or right, 0 a corner
  Cell cell = from;
  while (!(cell == to)) {
    if (ahead == 0) {
      if (corners == Corners::keep && (blocked[{cell.x + right, cell.y}] != 0 || blocked[{cell.x, cell.y + up}] != 0))
        return false;
      cell = {cell.x + right, cell.y + up};
      ahead += 2 * (dx - dy);
    } else if (ahead > 0) {
      cell.x += right;
      ahead -= 2 * dy;
    } else {
      cell.y += up;
      ahead += 2 * dx;
    }
    if (blocked[cell] != 0) return false;
  }
  return true;
}

PlanningResult theta_star(const PlanningProblem& problem, const Work& work) {
  need_start(problem, "theta_star");
  if (!problem.even() || problem.lattice != Lattice::rectangular)
    fail("theta_star: it takes length for cost, on a rectangular lattice: no difficulty and no drag expected");
  const Sight sees(problem);
  GraphSearch search(problem);
  std::int64_t looked = 0;
  while (const std::optional<Cell> cell = search.next()) {
    if (++looked % 16 == 1) work.poll();
    if (search.is_target(*cell)) return search_result(problem, search, cell);
    const Cell before = search.parent(*cell);
    for (const LatticeStep& step : lattice_steps(problem.lattice)) {
      const Cell to{cell->x + step.dx, cell->y + step.dy};
      if (!open_step(problem.blocked, problem.corners, *cell, step) || search.closed(to)) continue;
      const double straight = search.cost(before) + distance(before, to);
      if (straight < search.cost(to) && sees(before, to)) search.offer(to, straight, before);
      search.offer(to, search.cost(*cell) + step.length, *cell);
    }
  }
  return search_result(problem, search, std::nullopt);
}

}  // namespace meander
