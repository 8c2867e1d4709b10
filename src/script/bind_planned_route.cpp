// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/planned_route.hpp"

#include "script/bind.hpp"
#include "script/control_options.hpp"
#include "script/kit_module.hpp"
#include "script/planning_objects.hpp"
#include "script/robot_options.hpp"

namespace meander::script {

struct PlannedRouteTable {
  MapSourceTable source;
  std::optional<SubgoalOption> target;
  std::vector<SubgoalOption> targets;
  std::optional<Preset<Platform>> robot;
  PlannedRouteOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlannedRouteTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.source, visit);
  visit(Field{"target", "m", "where to"}, o.target);
  visit(Field{"targets", "m", "where to, several: to the one that is best"}, o.targets);
  visit(
      Field{
          "robot", "",
          "kind of robot: what its sonars hear and the map does not show is gone round, too, and robot_radius is that "
          "of its body"},
      o.robot);
  fields(o.options, visit);
}

namespace {

std::shared_ptr<Guide> route(const PlannedRouteTable& table, const Call& call) {
  const World* world = table.source.world.get();
  std::vector<Vec2> targets;
  if (table.target) targets.push_back(table.target->in(world).position);
  for (const SubgoalOption& target : table.targets) targets.push_back(target.in(world).position);
  if (targets.empty()) fail("option 'target': missing, {{x, y}} expected, or a list of them as 'targets'");
  PlannedRouteOptions options = table.options;
  std::optional<Platform> robot;
  if (table.robot) {
    robot = table.robot->value;
    options.robot_radius = robot->body.radius;
  }
  const Work work = call.work();
  return std::make_shared<Guide>(
      planned_route(map_of(table.source, work), std::move(targets), options, robot, work.stop));
}

}  // namespace

void bind_planned_route(lua_State* L) {
  Module(L, "meander.autonomy", "")
      .function<&route>(Doc{
          .name = "planned_route",
          .text = "A guide: plans a path on a map of cells and hands its points to the navigator, each the farthest "
                  "in sight. Plans anew when the navigator is trapped, with what is ahead taken as blocked, and "
                  "when an edit of the map, or what the robot's sonars hear, blocks the rest of the path. It sees the "
                  "map and the readings, never the world.",
          .args = {{"options", "the map, where to, and how"}},
          .returns = "the guide",
          .errors = "no target; none or several maps; a number out of range",
          .example = "w = meander.world.new { bounds = {{0, 0}, {8, 4}}, start = {1, 2, 0} } "
                     "g = meander.autonomy.planned_route { world = w, target = {6, 2} } "
                     "print(meander.sim.new({ world = w }):drive { navigator = 'potential_field', guide = g })"});
}

}  // namespace meander::script
