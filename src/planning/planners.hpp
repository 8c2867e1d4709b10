// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/harmonic_options.hpp"
#include "planning/landscape.hpp"
#include "planning/neural_map_options.hpp"

namespace meander {

/// The options of all planners side by side; each takes its own.
struct PlannerOptions {
  NeuralMapOptions neural_map{};
  HarmonicOptions harmonic{};
};

/// Solves the problem with the planner of this name. Misuse throws ArgumentError (see validate(), and unknown names);
/// no path is a result with a reason.
PlanningResult solve(const PlanningProblem& problem, const std::string& planner, const PlannerOptions& options = {},
                     const Work& work = {});

/// neural_map, distance_transform, harmonic, astar, theta_star.
std::vector<std::string> planner_names();
/// Throws ArgumentError unless it is one of these and, where cost is not `even`ly length, knows more than lengths.
void check_planner(const std::string& name, bool even = true);

}  // namespace meander
