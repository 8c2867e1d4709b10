// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/neural_net.hpp"

namespace meander {

/// Where a solver ended.
struct NeuralSolution {
  Activation v;
  std::int64_t relaxations = 0;
  double residual = 0;   ///< largest relative error of a unit's equation
  bool complete = true;  ///< false: ended as soon as the start had what it needs
  const char* solver = "active_list";
};

// [LM99] Efficient implementation: all units at once; and four crossing rasters in place. Both end early, as soon as
// the front reaches the start, where options.extent says so.
NeuralSolution solve_synchronous(const NeuralNet& net, const NeuralMapOptions& options, std::optional<Cell> start,
                                 const Work& work = {});
NeuralSolution solve_raster(const NeuralNet& net, const NeuralMapOptions& options, std::optional<Cell> start,
                            const Work& work = {});

/// [LM99+] Only units whose input has changed are updated, over-relaxed, until nothing changes; then every equation is
/// checked and what is not within the tolerance is taken up again. 12 to 25 updates a unit on maps of any kind and
/// size, where the rasters' number grows with the map.
NeuralSolution solve_active_list(const NeuralNet& net, const NeuralMapOptions& options, const Work& work = {});

/// The same from any activation, for units whose equations may have changed: theirs, and all that change with them, are
/// within the tolerance afterwards.
void settle(const NeuralNet& net, NeuralSolution& solution, std::vector<std::int32_t> active, double tolerance,
            const Work& work);

/// [LM99+] As much of the equilibrium as the path from the start needs: units in the order of the most that they can
/// mean to the start, until nothing is left that would change its activation by more than a ten thousandth. The paper
/// ends when the front arrives, and its path is up to 14 % longer than that of the equilibrium.
NeuralSolution solve_for_start(const NeuralNet& net, Cell start, const Work& work = {});

/// ln v of every cell that has any; the statistics know how many, and how many reachable units a path could not leave.
PlanningResult landscape_of(const NeuralNet& net, const NeuralSolution& solution, const PlanningProblem& problem,
                            const Work& work = {});

}  // namespace meander
