// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/item_options.hpp"
#include "script/kit_function.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "world/editing.hpp"

namespace meander::script {
namespace {

template <class Options>
Thing add(const std::shared_ptr<World>& world, const Options& options) {
  return {world, world->add(item_of(options))};
}

void remove(World& world, const Things& things) {
  const std::vector<Id> ids = resolve(world, things);
  world.transaction([&] {
    for (const Id id : ids) world.remove(id);
  });
}
void replace(World& world, const ThingRef& thing, const OptionTable& options) {
  const Id id = resolve(world, thing);
  world.replace(id, replacement(world.item(id), options));
}
void move_by(World& world, const Things& things, const Vec2& by) { move(world, resolve(world, things), by); }
void turn_by(World& world, const Things& things, double by, const std::optional<Vec2>& about) {
  turn(world, resolve(world, things), by, about);
}
void scale_by(World& world, const Things& things, double factor, const std::optional<Vec2>& about) {
  scale(world, resolve(world, things), factor, about);
}
void snap_to(World& world, const Things& things, double step) { snap(world, resolve(world, things), step); }
void rename_to(World& world, const ThingRef& thing, const std::string& name) {
  rename(world, resolve(world, thing), name);
}
void open(World& world, const ThingRef& door) { set_open(world, resolve(world, door), true); }
void close(World& world, const ThingRef& door) { set_open(world, resolve(world, door), false); }
int count_of(const std::optional<int>& steps) {
  if (steps && *steps < 0) fail("argument 1 ('steps'): an integer from 0 on expected, got {}", *steps);
  return steps.value_or(1);
}
int undo(World& world, const std::optional<int>& steps) { return world.undo(count_of(steps)); }
int redo(World& world, const std::optional<int>& steps) { return world.redo(count_of(steps)); }
void transaction(World& world, const Function& body) {
  world.transaction([&] { body.call(); });
}

constexpr const char* kAddErrors = "bad shape or number; name taken; ground needed by the start or a place";

void bind_adding(Type<World>& type) {
  type.method<&add<WallOptions>>(Doc{.name = "add_wall",
                                     .text = "Adds a thin wall through points.",
                                     .args = {{"options", "its points and more"}},
                                     .returns = "the new thing",
                                     .errors = kAddErrors,
                                     .example = "meander.world.new {}:add_wall { points = {{2, 2}, {4, 2}, {4, 3}} }"})
      .method<&add<PolygonOptions>>(
          Doc{.name = "add_polygon",
              .text = "Adds a solid polygon, with holes if wanted.",
              .args = {{"options", "its rim and more"}},
              .returns = "the new thing",
              .errors = kAddErrors,
              .example = "meander.world.new {}:add_polygon { outer = {{2, 2}, {4, 2}, {3, 4}} }"})
      .method<&add<BoxOptions>>(
          Doc{.name = "add_box",
              .text = "Adds a solid rectangle.",
              .args = {{"options", "its centre, size and more"}},
              .returns = "the new thing",
              .errors = kAddErrors,
              .example = "meander.world.new {}:add_box { center = {3, 2}, size = {0.6, 0.4}, heading = deg(30) }"})
      .method<&add<DiscOptions>>(Doc{.name = "add_disc",
                                     .text = "Adds a solid disc: a pole, a pillar, a bin.",
                                     .args = {{"options", "its centre, radius and more"}},
                                     .returns = "the new thing",
                                     .errors = kAddErrors,
                                     .example = "meander.world.new {}:add_disc { center = {3, 2}, radius = 0.2 }"})
      .method<&add<DoorOptions>>(Doc{.name = "add_door",
                                     .text = "Adds an obstacle that opens and closes; its keys tell its shape.",
                                     .args = {{"options", "its shape and more"}},
                                     .returns = "the new thing",
                                     .errors = kAddErrors,
                                     .example = "meander.world.new {}:add_door { from = {3, 2}, to = {4, 2} }"})
      .method<&add<MoverOptions>>(
          Doc{.name = "add_mover",
              .text = "Adds a disc that moves by itself once a simulation runs.",
              .args = {{"options", "where it starts and how it moves"}},
              .returns = "the new thing",
              .errors = kAddErrors,
              .example = "meander.world.new {}:add_mover { center = {3, 2}, radius = 0.3, waypoints = {{3, 5}} }"})
      .method<&add<LightOptions>>(Doc{.name = "add_light",
                                      .text = "Adds a light.",
                                      .args = {{"options", "its position and more"}},
                                      .returns = "the new thing",
                                      .errors = "bad number; name taken",
                                      .example = "meander.world.new {}:add_light { position = {3, 2} }"})
      .method<&add<PlaceOptions>>(
          Doc{.name = "add_place",
              .text = "Names a place: subgoals are given as places.",
              .args = {{"options", "its position and more"}},
              .returns = "the new thing",
              .errors = "name taken; not on free ground",
              .example = "meander.world.new {}:add_place { position = {3, 2}, name = 'hall' }"});
}

constexpr Arg kThings{"things",
                      "a thing, its name, a pattern such as 'crate*' (an exact name wins), or a list of these"};

void bind_changing(Type<World>& type) {
  type.method<&remove>(
          Doc{.name = "remove",
              .text = "Removes things.",
              .args = {kThings},
              .errors = "no such thing",
              .example = "w = meander.world.new {} w:remove(w:add_disc { center = {3, 2}, radius = 0.2 })"})
      .method<&replace>(Doc{.name = "replace",
                            .text = "Gives a thing a new form; the keys are those of its kind.",
                            .args = {{"thing", "the thing or its name"}, {"options", "the new form"}},
                            .errors = "as for adding it",
                            .example = "w = meander.world.new {} t = w:add_disc { center = {3, 2}, radius = 0.2 } "
                                       "w:replace(t, { center = {3, 2}, size = {1, 1} })"})
      .method<&move_by>(Doc{.name = "move",
                            .text = "Shifts things; movers take their waypoints along.",
                            .args = {kThings, {"by", "how far", "m"}},
                            .errors = "no such thing; it may not stand there",
                            .example =
                                "w = meander.world.new {} w:add_disc { center = {3, 2}, radius = 0.2, name = 'bin' } "
                                "w:move('bin', {1, 0})"})
      .method<&turn_by>(
          Doc{.name = "turn",
              .text = "Turns things counter-clockwise.",
              .args = {kThings, {"by", "angle", "rad"}, {"about", "point; their middle when left out", "m"}},
              .errors = "no such thing; it may not stand there",
              .example = "w = meander.world.new {} w:add_box { center = {3, 2}, size = {1, 2}, name = 'desk' } "
                         "w:turn('desk', deg(30))"})
      .method<&scale_by>(
          Doc{.name = "scale",
              .text = "Scales positions and sizes.",
              .args = {kThings, {"factor", "above 0"}, {"about", "point; their middle when left out", "m"}},
              .errors = "no such thing; it may not stand there",
              .example = "w = meander.world.new {} w:add_box { center = {3, 2}, size = {1, 2}, name = 'desk' } "
                         "w:scale('desk', 0.5)"})
      .method<&snap_to>(Doc{.name = "snap",
                            .text = "Moves points and centres to the nearest crossing of a grid.",
                            .args = {kThings, {"step", "distance of the grid lines", "m"}},
                            .errors = "no such thing; a shape would become invalid",
                            .example =
                                "w = meander.world.new {} w:add_disc { center = {3.1, 2}, radius = 0.2, name = 'bin' } "
                                "w:snap('bin', 0.5)"})
      .method<&rename_to>(
          Doc{.name = "rename",
              .text = "Gives a thing another name.",
              .args = {{"thing", "the thing or its name"}, {"name", "the new name"}},
              .errors = "no such thing; name taken",
              .example = "w = meander.world.new {} w:rename(w:add_light { position = {1, 1} }, 'lamp')"})
      .method<&open>(Doc{.name = "open",
                         .text = "Opens a door.",
                         .args = {{"door", "the door or its name"}},
                         .errors = "no such thing; no door",
                         .example = "w = meander.world.new {} w:open(w:add_door { from = {3, 2}, to = {4, 2} })"})
      .method<&close>(Doc{.name = "close",
                          .text = "Closes a door.",
                          .args = {{"door", "the door or its name"}},
                          .errors = "no such thing; no door; something stands there",
                          .example = "w = meander.world.new {} w:close(w:add_door { from = {3, 2}, to = {4, 2} })"});
}

void bind_history(Type<World>& type) {
  type.method<&undo>(Doc{.name = "undo",
                         .text = "Takes back edits; a transaction is one step.",
                         .args = {{"steps", "how many; 1 when left out"}},
                         .returns = "how many there were",
                         .errors = "a negative number of steps",
                         .example = "w = meander.world.new {} w:add_light { position = {1, 1} } print(w:undo())"})
      .method<&redo>(
          Doc{.name = "redo",
              .text = "Does again what undo took back.",
              .args = {{"steps", "how many; 1 when left out"}},
              .returns = "how many there were",
              .errors = "a negative number of steps",
              .example = "w = meander.world.new {} w:add_light { position = {1, 1} } w:undo() print(w:redo())"})
      .method<&transaction>(Doc{
          .name = "transaction",
          .text = "All or nothing: when the function fails, everything it did to the world is taken back and the error "
                  "goes on. One undo step.",
          .args = {{"body", "function that edits the world"}},
          .errors = "those of the function",
          .example = "w = meander.world.new {} w:transaction(function() w:add_light { position = {1, 1} } end)"});
}

}  // namespace

void bind_world_edit(lua_State* L) {
  Type<World> type(L);
  bind_adding(type);
  bind_changing(type);
  bind_history(type);
}

}  // namespace meander::script
