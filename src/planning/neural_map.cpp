// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_map.hpp"

#include "planning/neural_solution.hpp"

namespace meander {
namespace {

NeuralSolution equilibrium(const NeuralNet& net, const PlanningProblem& problem, const NeuralMapOptions& options,
                           const Work& work) {
  switch (options.solver) {
    case NeuralSolver::raster:
      return solve_raster(net, options, problem.start, work);
    case NeuralSolver::synchronous:
      return solve_synchronous(net, options, problem.start, work);
    default:
      return solve_active_list(net, options, work);
  }
}

}  // namespace

PlanningResult neural_map(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work) {
  validate(options);
  if (std::string reason = no_path_reason(problem, work); !reason.empty()) return {.value = {}, .reason = reason};
  const NeuralNet net = neural_net(problem, options, work);
  const NeuralSolution solution = equilibrium(net, problem, options, work);
  PlanningResult result = landscape_of(net, solution.v, problem);
  result.statistics.relaxations = solution.relaxations;
  result.statistics.residual = solution.residual;
  result.statistics.complete = solution.complete;
  return result;
}

}  // namespace meander
