// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/plan.hpp"
#include "script/kit_object.hpp"
#include "script/map_object.hpp"
#include "script/objects.hpp"
#include "script/values.hpp"

namespace meander {

inline std::size_t native_size(const PlanningMap& map) {
  return map.solid.cells().size() + 4 * map.difficulty.cells().size() + 8 * map.drag.cells().size();
}
inline std::size_t native_size(const Plan& plan) {
  return plan.problem.blocked.cells().size() + plan.problem.obstacles.cells().size() +
         4 * plan.problem.difficulty.cells().size() + 8 * plan.problem.drag.cells().size() +
         8 * plan.result.value.cells().size() + 16 * plan.path.points.size();
}

}  // namespace meander

namespace meander::script {

template <>
struct ObjectName<PlanningMap> {
  static constexpr const char* value = "grid_map";
};
template <>
struct ObjectName<Plan> {
  static constexpr const char* value = "plan";
};

/// Where a planner's map comes from.
struct MapSourceTable {
  std::shared_ptr<PlanningMap> map;
  std::shared_ptr<World> world;
  std::shared_ptr<SonarMap> sonar_map;
  std::optional<Rows> cells;
  double resolution = 0.05;
  Vec2 origin{0, 0};
  OccupancyOptions occupancy;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapSourceTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"map", "", "a map of meander.planning.map or read_map"}, o.map);
  visit(Field{"world", "", "or a world: its obstacles and closed doors as cells"}, o.world);
  visit(Field{"sonar_map", "", "or a map that a robot has built"}, o.sonar_map);
  visit(
      Field{"cells", "", "or rows of probabilities that a cell is solid, the lowest row first; not a number: unknown"},
      o.cells);
  visit(Field{"resolution", "m", "side of a cell, of worlds and rows", 1e-3, 1e3}, o.resolution);
  visit(Field{"origin", "m", "of rows: lower left corner"}, o.origin);
  fields(o.occupancy, visit);
}

/// The map that the table names; exactly one must be named. Throws ArgumentError.
std::shared_ptr<const PlanningMap> map_of(const MapSourceTable& table, const Work& work);

}  // namespace meander::script
