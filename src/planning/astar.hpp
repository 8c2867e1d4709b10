// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/landscape.hpp"

namespace meander {

/// The cheapest way from the start to a target by the lattice's steps: A*. With Corners::keep, its lengths on the
/// benchmarks of movingai.com are the published ones.
PlanningResult astar(const PlanningProblem& problem, const Work& work = {});

}  // namespace meander
