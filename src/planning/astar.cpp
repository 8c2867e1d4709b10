// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/astar.hpp"

#include "planning/graph_search.hpp"

namespace meander {

PlanningResult astar(const PlanningProblem& problem, const Work& work) {
  need_start(problem, "astar");
  GraphSearch search(problem);
  std::int64_t looked = 0;
  while (const std::optional<Cell> cell = search.next()) {
    if (++looked % 4096 == 1) work.poll();
    if (search.is_target(*cell)) return search_result(problem, search, cell);
    for (const LatticeStep& step : lattice_steps(problem.lattice, cell->y)) {
      const Cell to{cell->x + step.dx, cell->y + step.dy};
      if (open_step(problem.blocked, problem.corners, *cell, step) && !search.closed(to))
        search.offer(to, search.cost(*cell) + step_cost(problem, *cell, step), *cell);
    }
  }
  return search_result(problem, search, std::nullopt);
}

}  // namespace meander
