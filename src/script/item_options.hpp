// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/kit_options.hpp"
#include "script/objects.hpp"

namespace meander::script {

/// Option tables of the things in a world, under the keys of world/attributes.hpp.

struct SurfaceOptions {
  double echo = 1;
  std::optional<double> specular_limit;
};
template <class Options, class Visitor>
void surface_fields(Options& o, Visitor&& visit) {
  visit(Field{"echo", "", "strength of the echo", 0, 1}, o.echo);
  visit(Field{"specular_limit", "rad", "largest angle to the normal that echoes; the sonar's own when left out"},
        o.specular_limit);
}

struct WallOptions : SurfaceOptions {
  Required<std::vector<Vec2>> points;
  bool closed = false;
  std::string name;
};
struct PolygonOptions : SurfaceOptions {
  Required<std::vector<Vec2>> outer;
  std::vector<std::vector<Vec2>> holes;
  std::string name;
};
struct BoxOptions : SurfaceOptions {
  Required<Vec2> center;
  Required<Size> size;
  double heading = 0;
  std::string name;
};
struct DiscOptions : SurfaceOptions {
  Required<Vec2> center;
  Required<double> radius;
  std::string name;
};
/// Any shape, told by its keys: for doors and for replacing things.
struct ShapeOptions : SurfaceOptions {
  std::optional<Vec2> from, to;
  std::optional<std::vector<Vec2>> points;
  bool closed = false;
  std::optional<std::vector<Vec2>> outer;
  std::vector<std::vector<Vec2>> holes;
  std::optional<Vec2> center;
  std::optional<Size> size;
  double heading = 0;
  std::optional<double> radius;
  std::string name;
};
struct DoorOptions : ShapeOptions {
  bool open = false;
};
struct MoverOptions {
  Required<Vec2> center;
  Required<double> radius;
  Motion motion = Motion::waypoints;
  std::vector<Vec2> waypoints;
  double speed = 0.5;
  bool yields = true;
  std::string name;
};
struct LightOptions {
  Required<Vec2> position;
  double strength = 1;
  std::string name;
};
struct PlaceOptions {
  Required<Vec2> position;
  std::optional<double> heading;
  double tolerance = 0.25;
  std::string name;
};

inline constexpr Field kNameField{"name", "", "its name; \"kind number\" when left out"};

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WallOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"points", "m", "corners of the wall, at least two"}, o.points);
  visit(Field{"closed", "", "joins the last point to the first"}, o.closed);
  visit(kNameField, o.name);
  surface_fields(o, visit);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolygonOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"outer", "m", "corners of the rim, at least three"}, o.outer);
  visit(Field{"holes", "m", "rims of free areas inside"}, o.holes);
  visit(kNameField, o.name);
  surface_fields(o, visit);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, BoxOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"center", "m", "its centre"}, o.center);
  visit(Field{"size", "m", "extent along its own x and y"}, o.size);
  visit(Field{"heading", "rad", "turn of its own x axis"}, o.heading);
  visit(kNameField, o.name);
  surface_fields(o, visit);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DiscOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"center", "m", "its centre"}, o.center);
  visit(Field{"radius", "m", "its radius"}, o.radius);
  visit(kNameField, o.name);
  surface_fields(o, visit);
}
template <class Options, class Visitor>
void shape_fields(Options& o, Visitor&& visit) {
  visit(Field{"from", "m", "one end of a straight wall"}, o.from);
  visit(Field{"to", "m", "its other end"}, o.to);
  visit(Field{"points", "m", "corners of a wall"}, o.points);
  visit(Field{"closed", "", "joins the last of the points to the first"}, o.closed);
  visit(Field{"outer", "m", "corners of a polygon"}, o.outer);
  visit(Field{"holes", "m", "rims of its free areas"}, o.holes);
  visit(Field{"center", "m", "centre of a box or disc"}, o.center);
  visit(Field{"size", "m", "extent of a box"}, o.size);
  visit(Field{"heading", "rad", "turn of a box"}, o.heading);
  visit(Field{"radius", "m", "radius of a disc"}, o.radius);
  visit(kNameField, o.name);
  surface_fields(o, visit);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ShapeOptions>
void fields(Options& o, Visitor&& visit) { shape_fields(o, visit); }
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DoorOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"open", "", "an open door is not there"}, o.open);
  shape_fields(o, visit);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MoverOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"center", "m", "where it starts"}, o.center);
  visit(Field{"radius", "m", "its radius"}, o.radius);
  visit(Field{"motion", "", "how it moves"}, o.motion);
  visit(Field{"waypoints", "m", "visited in a round"}, o.waypoints);
  visit(Field{"speed", "m/s", "its speed", 0, 100}, o.speed);
  visit(Field{"yields", "", "stops for robots in its way; false: blind"}, o.yields);
  visit(kNameField, o.name);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LightOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"position", "m", "where it is"}, o.position);
  visit(Field{"strength", "", "how bright it is", 0, 1e9}, o.strength);
  visit(kNameField, o.name);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlaceOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"position", "m", "where it is"}, o.position);
  visit(Field{"heading", "rad", "wanted on arrival"}, o.heading);
  visit(Field{"tolerance", "m", "arrived when this near", 0, 1e9}, o.tolerance);
  visit(kNameField, o.name);
}

Item item_of(const WallOptions& o);
Item item_of(const PolygonOptions& o);
Item item_of(const BoxOptions& o);
Item item_of(const DiscOptions& o);
Item item_of(const ShapeOptions& o);
Item item_of(const DoorOptions& o);
Item item_of(const MoverOptions& o);
Item item_of(const LightOptions& o);
Item item_of(const PlaceOptions& o);

/// A table whose options are known only once the function has looked at its other arguments.
struct OptionTable {
  lua_State* L;
  int index;
  Path path;
  template <class Options>
  Options as() const {
    return Lua<Options>::read(L, index, path);
  }
};
template <>
struct Lua<OptionTable> {
  static OptionTable read(lua_State* L, int index, const Path& path) {
    if (!lua_istable(L, index)) expected(L, index, path, "table of options");
    return {L, lua_absindex(L, index), path};
  }
  static std::string type() { return "table"; }
};

/// The new form of a thing, from the options of its kind.
Item replacement(const Item& old, const OptionTable& table);

/// A thing's attributes with its kind, as a table for scripts.
struct ItemTable {
  Item item;
};
template <>
struct Lua<ItemTable> {
  static void push(lua_State* L, const ItemTable& value);
  static std::string type() { return "table"; }
};

/// A handle or a name.
struct ThingRef {
  std::string name;  ///< also of the handle's thing
  std::optional<Thing> thing;
};
template <>
struct Lua<ThingRef> {
  static ThingRef read(lua_State* L, int index, const Path& path);
  static std::string type() { return "thing or name"; }
};
/// One or several of them; names may be patterns with * and ?, where no thing is called so.
struct Things {
  std::vector<ThingRef> list;
};
template <>
struct Lua<Things> {
  static Things read(lua_State* L, int index, const Path& path);
  static std::string type() { return "thing, name, pattern or list of these"; }
};

/// The living thing that is meant; a handle of another world means the thing that has its id
/// and its name here, as in forks.
Id resolve(const World& world, const ThingRef& ref);
std::vector<Id> resolve(const World& world, const Things& things);

}  // namespace meander::script
