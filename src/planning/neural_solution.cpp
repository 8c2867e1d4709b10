// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_solution.hpp"

namespace meander {
namespace {

/// A unit that steepest ascent cannot leave: without activation beside one that has some, or a local maximum.
bool is_dead(const NeuralNet& net, const Activation& v, std::int32_t i) {
  const Extended& own = v[static_cast<std::size_t>(i)];
  bool some = false, higher = false;
  net.for_each_link(i, [&](std::int32_t j, int) {
    const Extended& other = v[static_cast<std::size_t>(j)];
    some = some || !other.zero();
    higher = higher || other.block > own.block || (other.block == own.block && other.value > own.value);
  });
  return own.zero() ? some : !higher && !net.is_target(i);
}

}  // namespace

PlanningResult landscape_of(const NeuralNet& net, const NeuralSolution& solution, const PlanningProblem& problem) {
  PlanningResult result{.value = Grid<double>(net.width, net.height, kNoValue, problem.blocked.frame)};
  for (int y = 0; y < net.height; ++y)
    for (int x = 0; x < net.width; ++x) {
      const std::int32_t i = net.index({x, y});
      if (net.links[static_cast<std::size_t>(i)] == 0) continue;
      const Extended& own = solution.v[static_cast<std::size_t>(i)];
      if (is_dead(net, solution.v, i)) ++result.statistics.dead_units;
      if (own.zero()) continue;
      result.value[{x, y}] = natural_log(own);
      ++result.statistics.cells;
    }
  result.statistics.relaxations = solution.relaxations;
  result.statistics.residual = solution.residual;
  result.statistics.complete = solution.complete;
  result.statistics.solver = solution.solver;
  return result;
}

}  // namespace meander
