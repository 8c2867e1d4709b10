// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/robot_options.hpp"

namespace meander::script {

Pose2 PoseOption::in(const World& world) const {
  if (!place) return pose;
  const Item& item = world.item(resolve(world, *place));
  const auto* found = std::get_if<Place>(&item);
  if (!found) fail("option 'start': place or {{x, y, heading}} expected, got {} '{}'", kind_of(item), name_of(item));
  return {found->position.x(), found->position.y(), found->heading.value_or(0)};
}

PoseOption Lua<PoseOption>::read(lua_State* L, int index, const Path& path) {
  if (lua_type(L, index) == LUA_TSTRING || test_box(L, index, tag_of<Thing>))
    return {{}, Lua<ThingRef>::read(L, index, path)};
  return {Lua<Pose2>::read(L, index, path), {}};
}

RobotOptions robot_options(const RobotTable& table, const World& world) {
  RobotOptions options{table.robot.value, table.sonar.value, table.drift.value, table.whisker, table.light, {}};
  if (table.start) options.start = table.start->in(world);
  return options;
}

}  // namespace meander::script
