// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/item_options.hpp"

#include <lauxlib.h>

#include "world/attributes.hpp"
#include "world/editing.hpp"

namespace meander::script {
namespace {

Surface surface_of(const SurfaceOptions& o) { return {o.echo, o.specular_limit}; }

Shape shape_of(const ShapeOptions& o) {
  const int forms =
      (o.from || o.to) + o.points.has_value() + o.outer.has_value() + o.size.has_value() + o.radius.has_value();
  if (forms != 1)
    fail("one shape expected: from and to, points, outer, center and size, or center and radius; got {}",
         forms ? "several" : "none");
  if (o.points) return Chain{*o.points, o.closed};
  if (o.outer) return Polygon{*o.outer, o.holes};
  if (o.from || o.to) {
    if (!o.from || !o.to) fail("option '{}': missing, {{x, y}} expected", o.from ? "to" : "from");
    return Chain{{*o.from, *o.to}, false};
  }
  if (!o.center) fail("option 'center': missing, {{x, y}} expected");
  if (o.size) return Rectangle{*o.center, {o.size->width, o.size->height}, o.heading};
  return Disc{*o.center, *o.radius};
}

bool is_pattern(const std::string& name) { return name.find_first_of("*?") != std::string::npos; }

}  // namespace

Item item_of(const WallOptions& o) { return Obstacle{o.name, Chain{o.points.value, o.closed}, surface_of(o)}; }
Item item_of(const PolygonOptions& o) { return Obstacle{o.name, Polygon{o.outer.value, o.holes}, surface_of(o)}; }
Item item_of(const BoxOptions& o) {
  const Vec2 size{o.size.value.width, o.size.value.height};
  return Obstacle{o.name, Rectangle{o.center.value, size, o.heading}, surface_of(o)};
}
Item item_of(const DiscOptions& o) { return Obstacle{o.name, Disc{o.center.value, o.radius.value}, surface_of(o)}; }
Item item_of(const ShapeOptions& o) { return Obstacle{o.name, shape_of(o), surface_of(o)}; }
Item item_of(const DoorOptions& o) { return Door{o.name, shape_of(o), o.open, surface_of(o)}; }
Item item_of(const MoverOptions& o) {
  return Mover{o.name, Disc{o.center.value, o.radius.value}, o.motion, o.waypoints, o.speed, o.yields};
}
Item item_of(const LightOptions& o) { return Light{o.name, o.position.value, o.strength}; }
Item item_of(const PlaceOptions& o) { return Place{o.name, o.position.value, o.heading, o.tolerance}; }

Item replacement(const Item& old, const OptionTable& table) {
  switch (old.index()) {
    case 0:
      return item_of(table.as<ShapeOptions>());
    case 1:
      return item_of(table.as<DoorOptions>());
    case 2:
      return item_of(table.as<MoverOptions>());
    case 3:
      return item_of(table.as<LightOptions>());
    default:
      return item_of(table.as<PlaceOptions>());
  }
}

void Lua<ItemTable>::push(lua_State* L, const ItemTable& value) {
  lua_newtable(L);
  lua_pushstring(L, kind_of(value.item));
  lua_setfield(L, -2, "kind");
  for (const Attribute& attribute : attributes(value.item)) {
    script::push(L, attribute.value);
    lua_setfield(L, -2, attribute.key);
  }
}

ThingRef Lua<ThingRef>::read(lua_State* L, int index, const Path& path) {
  if (lua_type(L, index) == LUA_TSTRING) return {Lua<std::string>::read(L, index, path), {}};
  if (!test_box(L, index, tag_of<Thing>)) expected(L, index, path, type());
  const Thing thing = *read_object<Thing>(L, index, path);
  return {name_of(thing.world->item(thing.id)), thing};
}

Things Lua<Things>::read(lua_State* L, int index, const Path& path) {
  if (lua_istable(L, index)) return {Lua<std::vector<ThingRef>>::read(L, index, path)};
  if (lua_type(L, index) != LUA_TSTRING && !test_box(L, index, tag_of<Thing>)) expected(L, index, path, type());
  return {{Lua<ThingRef>::read(L, index, path)}};
}

Id resolve(const World& world, const ThingRef& ref) {
  if (!ref.thing) return world.find(ref.name);
  const Id id = ref.thing->id;
  if (ref.thing->world.get() == &world) return id;
  if (!world.alive(id) || name_of(world.item(id)) != ref.name)
    fail("the thing '{}' is of another world, and here no thing has its number and name", ref.name);
  return id;
}

std::vector<Id> resolve(const World& world, const Things& things) {
  std::vector<Id> ids;
  for (const ThingRef& ref : things.list) {
    if (ref.thing || !is_pattern(ref.name) || world.has(ref.name)) {
      ids.push_back(resolve(world, ref));
      continue;
    }
    const std::vector<Id> found = matching(world, ref.name);
    if (found.empty()) fail("no thing fits the pattern '{}'", ref.name);
    ids.insert(ids.end(), found.begin(), found.end());
  }
  return ids;
}

}  // namespace meander::script
