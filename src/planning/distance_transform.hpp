// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/landscape.hpp"

namespace meander {

/// The least cost from every cell to a target by the lattice's steps, as minus that cost [cells]: Jarvis' distance
/// transform, exact, by Dijkstra's algorithm with buckets.
PlanningResult distance_transform(const PlanningProblem& problem, const Work& work = {});

}  // namespace meander
