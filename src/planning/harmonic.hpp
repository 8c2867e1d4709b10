// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/harmonic_options.hpp"
#include "planning/landscape.hpp"

namespace meander {

/// Connolly's harmonic function: 1 at the targets, 0 at walls and the rim, everywhere else the mean of the four
/// neighbours: the chance of a random walk to meet a target before a wall. The landscape is its logarithm. Throws
/// ArgumentError where costs are not lengths on a rectangular lattice, where corners are cut (its walks take no
/// diagonal steps), and for more than kMostExactCells exactly.
PlanningResult harmonic(const PlanningProblem& problem, const HarmonicOptions& options = {}, const Work& work = {});

/// Largest exact system: a factorisation cannot be interrupted.
inline constexpr std::size_t kMostExactCells = 1 << 18;

}  // namespace meander
