// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/plan.hpp"

namespace meander {

std::vector<Vec2> Plan::points() const {
  std::vector<Vec2> points;
  points.reserve(path.points.size());
  for (const Vec2& point : path.points) points.push_back(in_metres(problem.blocked.frame, point));
  return points;
}

double Plan::value(const Vec2& point) const {
  return result.value.at(cell_at(problem.lattice, problem.blocked.frame.in_cells(point)), kNoValue);
}

void find_path(Plan& plan, const Work& work) {
  const Clearance clearance(plan.problem.solid(), work);
  plan.path = extract_path(plan.problem, plan.result, plan.kind, clearance, work);
  plan.measures = measure_path(plan.path.points, clearance, work);
  plan.clear = !plan.path.points.empty() && certified(plan.measures, plan.problem.robot_radius);
}

Plan make_plan(PlanningProblem problem, const std::string& planner, const PlannerOptions& options, PathKind kind,
               const Work& work) {
  Plan plan{.planner = planner, .kind = kind, .problem = std::move(problem)};
  plan.result = solve(plan.problem, planner, options, work);
  if (plan.problem.start) find_path(plan, work);
  return plan;
}

}  // namespace meander
