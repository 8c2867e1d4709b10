// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_tiles.hpp"

#include "planning/neural_solution.hpp"

namespace meander {

bool fits_tiles(const PlanningProblem& problem, const NeuralMapOptions& options) {
  return options.solver == NeuralSolver::tiles && problem.even() && problem.lattice == Lattice::rectangular &&
         options.weights == WeightLaw::inverse;
}

bool is_maze(const TileMap& map) {
  constexpr std::size_t kLeastCells = 40;  // of a unit on average; below, tiles are mostly walls
  return map.cell_count < kLeastCells * map.units.size();
}

PlanningResult solve_tiles(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work,
                           const TileKernel* kernel) {
  TileMap map = tile_map(problem, work);
  if (kernel == nullptr && is_maze(map)) {
    const NeuralNet net = neural_net(problem, options, work);
    return landscape_of(net, solve_active_list(net, options, work), problem, work);
  }
  TileSolver solver(std::move(map), options, kernel != nullptr ? *kernel : *tile_kernels().back());
  solver.solve(problem, work);
  return solver.landscape(problem, work);
}

}  // namespace meander
