// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/control_options.hpp"

namespace meander::script {
namespace {

struct SubgoalTable {
  Required<double> x, y;
  double tolerance = Subgoal{}.tolerance;
  std::optional<double> heading;
  std::string name;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SubgoalTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"x", "m", "where it is"}, o.x);
  visit(Field{"y", "m", "where it is"}, o.y);
  visit(Field{"tolerance", "m", "arrived when this near", 0, 1e6}, o.tolerance);
  visit(Field{"heading", "rad", "wanted on arrival"}, o.heading);
  visit(Field{"name", "", "for people"}, o.name);
}

}  // namespace

Subgoal SubgoalOption::in(const World* world) const {
  if (!place) return subgoal;
  if (!world) fail("subgoal '{}': {{x, y}} expected, a guide knows no world", place->name);
  const Item& item = world->item(resolve(*world, *place));
  const auto* found = std::get_if<Place>(&item);
  if (!found) fail("option 'subgoals': a place or {{x, y}} expected, got {} '{}'", kind_of(item), name_of(item));
  return {found->position, found->tolerance, found->heading, found->name};
}

SubgoalOption Lua<SubgoalOption>::read(lua_State* L, int index, const Path& path) {
  if (lua_type(L, index) == LUA_TSTRING || test_box(L, index, tag_of<Thing>))
    return {{}, Lua<ThingRef>::read(L, index, path)};
  if (!lua_istable(L, index)) expected(L, index, path, type());
  const int table = lua_absindex(L, index);
  SubgoalOption option;
  if (lua_rawlen(L, table) > 0) {
    // A point, perhaps with more keys, as guides get and return it.
    option.subgoal.position = Lua<Vec2>::read(L, table, path);
    const auto number = [&](const char* name) {
      push_option(L, table, name);
      const auto value =
          Lua<std::optional<double>>::read(L, -1, Path{.kind = Path::Kind::option, .name = name, .parent = &path});
      lua_pop(L, 1);
      return value;
    };
    option.subgoal.tolerance = number("tolerance").value_or(option.subgoal.tolerance);
    option.subgoal.heading = number("heading");
    return option;
  }
  const auto read = Lua<SubgoalTable>::read(L, table, path);
  option.subgoal = {Vec2(read.x.value, read.y.value), read.tolerance, read.heading, read.name};
  return option;
}

void Lua<Subgoal>::push(lua_State* L, const Subgoal& subgoal) {
  push_point(L, subgoal.position.data(), 2);
  lua_pushnumber(L, subgoal.tolerance);
  lua_setfield(L, -2, "tolerance");
  script::push(L, subgoal.heading);
  lua_setfield(L, -2, "heading");
  script::push(L, subgoal.name);
  lua_setfield(L, -2, "name");
}

void Lua<NavigatorStep>::push(lua_State* L, const NavigatorStep& step) {
  lua_createtable(L, 0, 4);
  lua_pushnumber(L, step.command.v);
  lua_setfield(L, -2, "v");
  lua_pushnumber(L, step.command.w);
  lua_setfield(L, -2, "w");
  script::push(L, step.status);
  lua_setfield(L, -2, "status");
  script::push(L, step.reason);
  lua_setfield(L, -2, "reason");
}

}  // namespace meander::script
