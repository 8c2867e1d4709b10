// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_map.hpp"

#include "planning/neural_solution.hpp"
#include "planning/neural_tiles.hpp"

namespace meander {

PlanningResult neural_map(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work) {
  validate(options);
  if (std::string reason = no_path_reason(problem, work); !reason.empty()) return {.value = {}, .reason = reason};
  const bool even = problem.even() && problem.lattice == Lattice::rectangular && options.weights == WeightLaw::inverse;
  if (options.solver == NeuralSolver::tiles && even) return solve_tiles(problem, options, work);
  const NeuralNet net = neural_net(problem, options, work);
  const NeuralSolution solution =
      options.solver == NeuralSolver::raster        ? solve_raster(net, options, problem.start, work)
      : options.solver == NeuralSolver::synchronous ? solve_synchronous(net, options, problem.start, work)
                                                    : solve_active_list(net, options, work);
  return landscape_of(net, solution, problem);
}

}  // namespace meander
