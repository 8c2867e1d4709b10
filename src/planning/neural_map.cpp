// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_map.hpp"

#include "planning/neural_solution.hpp"
#include "planning/neural_tiles.hpp"

namespace meander {

PlanningResult neural_map(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work) {
  validate(options);
  if (std::string reason = no_path_reason(problem, work); !reason.empty()) return {.value = {}, .reason = reason};
  const bool swept = options.solver == NeuralSolver::raster || options.solver == NeuralSolver::synchronous;
  const bool for_start = options.extent == NeuralExtent::start && problem.start && !swept;
  if (fits_tiles(problem, options) && !for_start) return solve_tiles(problem, options, work);
  const NeuralNet net = neural_net(problem, options, work);
  if (for_start) return landscape_of(net, solve_for_start(net, *problem.start, work), problem, work);
  if (options.solver == NeuralSolver::raster)
    return landscape_of(net, solve_raster(net, options, problem.start, work), problem, work);
  if (options.solver == NeuralSolver::synchronous)
    return landscape_of(net, solve_synchronous(net, options, problem.start, work), problem, work);
  return landscape_of(net, solve_active_list(net, options, work), problem, work);
}

}  // namespace meander
