// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_solution.hpp"

namespace meander {

PlanningResult landscape_of(const NeuralNet& net, const NeuralSolution& solution, const PlanningProblem& problem,
                            const Work& work) {
  PlanningResult result{.value = Grid<double>(net.width, net.height, kNoValue, problem.blocked.frame)};
  for (int y = 0; y < net.height; ++y) {
    work.poll();
    for (int x = 0; x < net.width; ++x) {
      const std::int32_t i = net.index({x, y});
      const Extended& own = solution.v[static_cast<std::size_t>(i)];
      if (net.links[static_cast<std::size_t>(i)] == 0 || own.zero()) continue;
      result.value[{x, y}] = natural_log(own);
      ++result.statistics.cells;
    }
  }
  result.statistics.dead_units = dead_units(problem, result.value, work);
  result.statistics.relaxations = solution.relaxations;
  result.statistics.residual = solution.residual;
  result.statistics.complete = solution.complete;
  result.statistics.solver = solution.solver;
  return result;
}

}  // namespace meander
