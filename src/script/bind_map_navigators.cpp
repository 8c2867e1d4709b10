// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/map_navigators.hpp"
#include "script/bind.hpp"
#include "script/control_options.hpp"
#include "script/kit_module.hpp"
#include "script/map_object.hpp"
#include "script/objects.hpp"
#include "script/robot_options.hpp"

namespace meander::script {

/// The map that a navigator keeps for itself.
struct OwnMapTable {
  MapChoice choice;
  LocalMapOptions local;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, OwnMapTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.choice, visit);
  fields(o.local, visit);
}

/// A window about as wide as the polar map, whose scope is 2.54 m.
constexpr int kCellsOfScope = 104;

struct MapNavigatorTable {
  Preset<Platform> robot;
  OwnMapTable map{.choice = {}, .local = {.size = kCellsOfScope, .fusion = {}}};
  PolarOptions polar;
  MapObstacleOptions obstacles;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapNavigatorTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot that it drives"}, o.robot);
  visit(Field{"map", "", "the local map from which it takes its obstacles"}, o.map);
  visit(Field{"polar", "", "the polar navigator"}, o.polar);
  fields(o.obstacles, visit);
}

struct MapSafetyTable {
  Preset<Platform> robot;
  OwnMapTable map;
  MapSafetyOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapSafetyTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot that is driven"}, o.robot);
  visit(Field{"map", "", "the local map that stops it"}, o.map);
  fields(o.options, visit);
}

namespace {

std::shared_ptr<LocalMap> own_map(const OwnMapTable& table, const Platform& platform, const Call& call) {
  auto map = std::make_shared<LocalMap>(platform, table.choice.model(platform), table.local);
  account(call.L, map->bytes());
  return map;
}

std::shared_ptr<Navigator> map_navigator(const MapNavigatorTable& table, const Call& call) {
  const Platform& platform = table.robot.value;
  return std::make_shared<Navigator>(
      polar_on_map(platform, own_map(table.map, platform, call), table.polar, table.obstacles));
}

std::shared_ptr<Navigator> safety(const NavigatorOption& navigator, const std::optional<MapSafetyTable>& given,
                                  const Call& call) {
  const MapSafetyTable table = given.value_or(MapSafetyTable{});
  const Platform& platform = table.robot.value;
  return std::make_shared<Navigator>(
      with_map_safety(navigator.make(platform), platform, own_map(table.map, platform, call), table.options));
}

}  // namespace

void bind_map_navigators(lua_State* L) {
  Module(L, "meander.autonomy", "")
      .function<&map_navigator>(
          Doc{.name = "map_navigator",
              .text = "The polar navigator that takes its obstacles from a local map instead of single readings.",
              .args = {{"options", "the robot, the map, the navigator"}},
              .returns = "the navigator",
              .errors = "an unknown model; a number out of range",
              .example = "print(meander.autonomy.map_navigator { map = { model = 'elfes' }, occupied = 0.6 })"})
      .function<&safety>(
          Doc{.name = "map_safety",
              .text = "A navigator whose commands are slowed down where a local map shows something in the way.",
              .args = {{"navigator", "who drives, as sim:drive takes it"},
                       {"options", "the robot, the map, how near it may get"}},
              .returns = "the navigator",
              .errors = "an unknown model; a number out of range",
              .example = "print(meander.autonomy.map_safety(meander.polar.potential_field {}, { map = { model = "
                         "'elfes' } }))"});
}

}  // namespace meander::script
