// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/control_options.hpp"
#include "script/planning_objects.hpp"

namespace meander::script {

/// From where to where, whoever plans.
struct TaskTable {
  std::optional<SubgoalOption> start;
  std::optional<SubgoalOption> target;
  std::vector<SubgoalOption> targets;
  PathKind path = PathKind::gradient;
  double robot_radius = 0;
  Corners corners = Corners::keep;
  Lattice lattice = Lattice::rectangular;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TaskTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"start", "m", "where from; left out: the landscape alone"}, o.start);
  visit(Field{"target", "m", "where to"}, o.target);
  visit(Field{"targets", "m", "where to, several: to the one that is best"}, o.targets);
  visit(Field{"path", "", "how the path is read off the landscape"}, o.path);
  visit(Field{"robot_radius", "m", "what is solid is kept this far from the path", 0, 1000}, o.robot_radius);
  visit(Field{"corners", "", "may diagonal steps pass the corner of a blocked cell"}, o.corners);
  visit(Field{"lattice", "", "which cells are neighbours"}, o.lattice);
}

struct PlanTable {
  MapSourceTable source;
  std::string planner = "neural_map";
  TaskTable task;
  PlannerOptions planners;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlanTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.source, visit);
  visit(Field{"planner", "", "who plans: neural_map, distance_transform, harmonic, astar or theta_star"}, o.planner);
  fields(o.task, visit);
  fields(o.planners.neural_map, visit);
  visit(Field{"harmonic", "", "options of the harmonic function"}, o.planners.harmonic);
}

using Planned = std::tuple<std::shared_ptr<Plan>, std::optional<std::string>>;

inline Planned or_reason(std::shared_ptr<Plan> plan) {
  if (plan->reason().empty()) return {std::move(plan), std::nullopt};
  return {nullptr, "no path: " + plan->reason()};
}

/// `world`: where places have names.
inline PlanningTask task_of(const TaskTable& table, const World* world) {
  PlanningTask task{.start = std::nullopt,
                    .targets = {},
                    .robot_radius = table.robot_radius,
                    .corners = table.corners,
                    .lattice = table.lattice};
  if (table.start) task.start = table.start->in(world).position;
  if (table.target) task.targets.push_back(table.target->in(world).position);
  for (const SubgoalOption& target : table.targets) task.targets.push_back(target.in(world).position);
  if (task.targets.empty()) fail("option 'target': missing, {{x, y}} expected, or a list of them as 'targets'");
  return task;
}

}  // namespace meander::script
