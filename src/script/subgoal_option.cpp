// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/control_options.hpp"
#include "world/validity.hpp"

namespace meander::script {
namespace {

/// What a subgoal is besides a point.
struct SubgoalMore {
  double tolerance = Subgoal{}.tolerance;
  std::optional<double> heading;
  std::string name;
};
template <class Options, class Visitor>
void more_fields(Options& o, Visitor&& visit) {
  visit(Field{"tolerance", "m", "arrived when this near", 0, 1e6}, o.tolerance);
  visit(Field{"heading", "rad", "wanted on arrival"}, o.heading);
  visit(Field{"name", "", "for people"}, o.name);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SubgoalMore>
void fields(Options& o, Visitor&& visit) { more_fields(o, visit); }

struct SubgoalTable : SubgoalMore {
  Required<double> x, y;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SubgoalTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"x", "m", "where it is"}, o.x);
  visit(Field{"y", "m", "where it is"}, o.y);
  more_fields(o, visit);
}

SubgoalOption subgoal_at(const Vec2& position, const SubgoalMore& more, const Path& path) {
  if (more.heading && !(std::abs(*more.heading) <= kLargestHeading))
    fail("option '{}heading': a number from {} to {} [rad] expected, got {}", option_prefix(path), -kLargestHeading,
         kLargestHeading, *more.heading);
  return {{position, more.tolerance, more.heading, more.name}, {}};
}

/// Pushes a copy of a table without its list part.
void push_without_list(lua_State* L, int table) {
  luaL_checkstack(L, 5, nullptr);
  lua_newtable(L);
  lua_pushnil(L);
  for (; lua_next(L, table); lua_pop(L, 1)) {
    if (lua_isinteger(L, -2)) continue;
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, -5);
  }
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
  if (lua_rawlen(L, table) > 0) {
    // A point, perhaps with more keys, as guides get and return it.
    const Vec2 position = Lua<Vec2>::read(L, table, path);
    push_without_list(L, table);
    const auto more = Lua<SubgoalMore>::read(L, -1, path);
    lua_pop(L, 1);
    return subgoal_at(position, more, path);
  }
  const auto read = Lua<SubgoalTable>::read(L, table, path);
  return subgoal_at({read.x.value, read.y.value}, read, path);
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
