// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <limits>

#include "planning/problem.hpp"

namespace meander {

/// Of cells that are blocked, cut off, or that the planner did not look at.
inline constexpr double kNoValue = -std::numeric_limits<double>::infinity();

struct PlanningStatistics {
  std::int64_t cells = 0;        ///< from which a target can be reached
  std::int64_t relaxations = 0;  ///< updates of a cell's value, all together
  std::int64_t dead_units = 0;   ///< reachable cells without a value that a path could follow
  double residual = 0;           ///< largest relative error of a cell's equation at the end
  bool complete = true;          ///< false: ended as soon as the start had what it needs, as searches do
  const char* solver = "";       ///< the one that ran, of planners that have several
};

/// What every planner gives back.
struct PlanningResult {
  /// Rises along every way to a target: ln v of a neural map (0 at the targets), minus the cost that is left [cells],
  /// the logarithm of the chance to meet a target first for harmonic functions. kNoValue where there is none.
  Grid<double> value;
  bool logarithmic = true;  ///< the value is the logarithm of an activation or a chance, not minus a cost
  /// Of searches, which find a path and no landscape: through these points [cells], start and target included.
  std::vector<Vec2> way{};
  std::string reason{};  ///< why there is no path; empty when there is a landscape or a way
  PlanningStatistics statistics{};
};

/// Of a logarithmic landscape: free cells that a path could not leave, because no step leads to a higher value, or that
/// have none beside one that has some.
std::int64_t dead_units(const PlanningProblem& problem, const Grid<double>& value, const Work& work = {});

}  // namespace meander
