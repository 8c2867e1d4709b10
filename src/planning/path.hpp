// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/clearance.hpp"
#include "planning/landscape.hpp"

namespace meander {

/// How a path is read off a landscape of activations v. gradient: continuously along the interpolated gradient of ln v.
/// Or from cell to cell, to the neighbour j of the best v_j, of the best (v_j - v_i) / rho, or of the best
/// (ln v_j - ln v_i) / rho. Where the landscape is minus a cost, it takes the place of ln v in gradient and log_slope,
/// and of v in the others.
enum class PathKind { gradient, steepest, slope, log_slope };
template <>
struct EnumNames<PathKind> {
  static constexpr std::pair<PathKind, const char*> entries[] = {{PathKind::gradient, "gradient"},
                                                                 {PathKind::steepest, "steepest"},
                                                                 {PathKind::slope, "slope"},
                                                                 {PathKind::log_slope, "log_slope"}};
};

/// From the centre of the start's cell to that of a target's [cells].
struct PlannedPath {
  std::vector<Vec2> points;
  std::string reason{};  ///< why there is none; empty when there is one
  int fallbacks = 0;     ///< steps to the best neighbour that the gradient needed
};

/// Follows the landscape from the problem's start, which must be set; of a search, gives its way.
PlannedPath extract_path(const PlanningProblem& problem, const PlanningResult& result, PathKind kind,
                         const Clearance& clearance, const Work& work = {});

/// Is it one of the problem's targets?
bool is_target(const PlanningProblem& problem, Cell cell);

/// The neighbour that the kind prefers, among those of a higher value; nothing at a local maximum.
std::optional<Cell> best_neighbour(const PlanningProblem& problem, const PlanningResult& result, PathKind kind,
                                   Cell cell);

}  // namespace meander
