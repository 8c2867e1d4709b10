// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/landscape.hpp"
#include "planning/neural_map_options.hpp"

namespace meander {

/// Activation spreads from the targets, value = ln v at the equilibrium v_i = Phi(beta sum_j w_ij v_j). [LM99] Neural
/// maps for global path planning. Never underflows; a reachable cell always has a neighbour of more activation.
/// NeuralSolver::tiles is for rectangular lattices where cost is length; other problems go to active_list.
PlanningResult neural_map(const PlanningProblem& problem, const NeuralMapOptions& options = {}, const Work& work = {});

}  // namespace meander
