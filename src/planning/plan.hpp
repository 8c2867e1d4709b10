// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/path.hpp"
#include "planning/path_measures.hpp"
#include "planning/planners.hpp"
#include "planning/planning_map.hpp"

namespace meander {

/// A task solved: the landscape, the path on it, and what it is like. Without a start there is no path.
struct Plan {
  std::string planner;
  PathKind kind = PathKind::gradient;
  PlanningProblem problem;
  PlanningResult result{};
  PlannedPath path{};       ///< [cells]
  PathMeasures measures{};  ///< [cells]
  bool clear = false;       ///< the whole path keeps the robot's body clear of all that is solid, for certain

  /// Why there is no path; empty where there is one, and where no start was given.
  const std::string& reason() const { return result.reason.empty() ? path.reason : result.reason; }
  double resolution() const { return problem.blocked.frame.resolution; }
  /// The path in metres.
  std::vector<Vec2> points() const;
  /// The landscape's value in the cell of the point [m]; kNoValue outside.
  double value(const Vec2& point) const;
};

Plan make_plan(PlanningProblem problem, const std::string& planner, const PlannerOptions& options = {},
               PathKind kind = PathKind::gradient, const Work& work = {});

/// The path of a plan whose landscape is there, anew: another start [cells] or another kind of path.
void find_path(Plan& plan, const Work& work = {});

}  // namespace meander
