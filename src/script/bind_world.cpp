// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/item_options.hpp"
#include "script/kit_function.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/picture.hpp"
#include "world/editing.hpp"
#include "world/world_diff.hpp"
#include "world/world_file.hpp"

namespace meander::script {
namespace {

using WorldPtr = std::shared_ptr<World>;

std::string hash(const World& world) { return fmt::format("{:016x}", world.hash()); }
std::string title(const World& world) { return world.header().title; }
std::string note(const World& world) { return world.header().note; }
Box bounds(const World& world) { return world.header().bounds; }
std::optional<Pose2> start(const World& world) { return world.header().start; }

std::vector<std::string> names(const World& world, const std::optional<std::string>& pattern) {
  std::vector<std::string> result;
  for (const Id id : matching(world, pattern.value_or("*"))) result.push_back(name_of(world.item(id)));
  return result;
}

std::vector<Thing> things(const WorldPtr& world, const std::optional<std::string>& pattern) {
  std::vector<Thing> result;
  for (const Id id : matching(*world, pattern.value_or("*"))) result.push_back({world, id});
  return result;
}

template <class Kind>
std::vector<Thing> of_kind(const WorldPtr& world) {
  std::vector<Thing> result;
  for (const Id id : world->ids())
    if (std::holds_alternative<Kind>(world->item(id))) result.push_back({world, id});
  return result;
}

Thing thing(const WorldPtr& world, const ThingRef& name) { return {world, resolve(*world, name)}; }
ItemTable get(const World& world, const ThingRef& thing) { return {world.item(resolve(world, thing))}; }

WorldPtr fork(const World& world) { return std::make_shared<World>(world); }

void save(const World& world, const OutputFile& file) {
  const std::string& path = file.path;
  if (path.ends_with(".toml"))
    write_world(path, world);
  else
    save_drawing(path, picture_of(world), ".toml, .svg or .png");
}

DrawList picture(const World& world) { return picture_of(world); }

std::string text(const World& world) {
  std::map<std::string, int> count;
  for (const Id id : world.ids()) ++count[kind_of(world.item(id))];
  const Header& header = world.header();
  const Vec2 size = header.bounds.size();
  std::string text = fmt::format("world \"{}\": {:.1f} x {:.1f} m, {} obstacle{}", header.title, size.x(), size.y(),
                                 count["obstacle"], count["obstacle"] == 1 ? "" : "s");
  for (const char* kind : {"door", "mover", "light", "place"})
    if (count[kind]) text += fmt::format(", {} {}{}", count[kind], kind, count[kind] == 1 ? "" : "s");
  return text;
}

bool equal(const World& a, const World& b) { return a == b; }

void bind_reading(Type<World>& type) {
  type.method<&names>(Doc{.name = "names",
                          .text = "The names of the things in the order they were added.",
                          .args = {{"pattern", "only names that fit it: * any run of characters, ? one character"}},
                          .returns = "list of names",
                          .example = "print(#meander.world.open('worlds/office.toml'):names 'door*')"})
      .method<&things>(
          Doc{.name = "things",
              .text = "Handles of the things in the order they were added.",
              .args = {{"pattern", "only names that fit it: * any run of characters, ? one character"}},
              .returns = "list of things",
              .example = "for _, t in ipairs(meander.world.open('worlds/office.toml'):things()) do print(t) end"})
      .method<&of_kind<Obstacle>>(Doc{.name = "obstacles",
                                      .text = "Handles of the obstacles in the order they were added.",
                                      .returns = "list of things",
                                      .example = "print(#meander.world.open('worlds/office.toml'):obstacles())"})
      .method<&of_kind<Place>>(Doc{.name = "places",
                                   .text = "Handles of the named places in the order they were added.",
                                   .returns = "list of things",
                                   .example = "print(meander.world.open('worlds/office.toml'):places()[1].name)"})
      .method<&thing>(Doc{.name = "thing",
                          .text = "The handle of a thing.",
                          .args = {{"name", "its name"}},
                          .returns = "the thing",
                          .errors = "no such name",
                          .example = "print(meander.world.open('worlds/office.toml'):thing 'hall')"})
      .method<&get>(Doc{.name = "get",
                        .text = "Everything about a thing, under the keys that add and replace take.",
                        .args = {{"thing", "the thing or its name"}},
                        .returns = "table with kind, name, shape and the rest",
                        .errors = "no such thing",
                        .example = "print(meander.world.open('worlds/office.toml'):get('hall').position)"})
      .method<&fork>(Doc{.name = "fork",
                         .text = "An independent copy, with its own history of edits.",
                         .returns = "the copy",
                         .example = "w = meander.world.new {} v = w:fork() print(v == w)"})
      .method<&difference>(Doc{.name = "diff",
                               .text = "What turns this world into another, one line each.",
                               .args = {{"other", "the other world"}},
                               .returns = "list of lines, empty for equal worlds",
                               .example = "w = meander.world.new {} print(#w:diff(w:fork()))"})
      .method<&world_script>(Doc{.name = "log",
                                 .text = "A Lua script that builds this world with all its undo steps.",
                                 .returns = "the script",
                                 .example = "print(meander.world.new { title = 'empty' }:log())"})
      .method<&to_toml>(Doc{.name = "to_toml",
                            .text = "The text of the world file: equal worlds give equal texts.",
                            .returns = "TOML text",
                            .example = "print(meander.world.new { title = 'empty' }:to_toml())"})
      .method<&hash>(Doc{.name = "hash",
                         .text = "Hash of everything that stands, not of the history.",
                         .returns = "16 hexadecimal digits",
                         .example = "print(meander.world.new {}:hash())"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes the world (.toml) or its picture (.svg, .png), at once or not at all.",
                         .args = {{"path", "the suffix says what is written"}},
                         .errors = "unknown suffix; the file cannot be written",
                         .example = "meander.world.new {}:save(os.tmpname() .. '.toml')"});
}

void bind_header(Type<World>& type) {
  type.property<&title>(
          PropertyDoc{.name = "title", .text = "Its name.", .example = "print(meander.world.new {}.title)"})
      .property<&note>(PropertyDoc{
          .name = "note", .text = "What it shows, and its source.", .example = "print(meander.world.new {}.note)"})
      .property<&bounds>(PropertyDoc{.name = "bounds",
                                     .text = "Lower left and upper right corner.",
                                     .unit = "m",
                                     .example = "print(meander.world.new {}.bounds[2].x)"})
      .property<&start>(PropertyDoc{.name = "start",
                                    .text = "Where robots start, nil when it is not said.",
                                    .unit = "m, rad",
                                    .example = "print(meander.world.new { start = {1, 1, 0} }.start)"});
}

}  // namespace

void bind_world(lua_State* L) {
  Type<World> type(L, "The truth: walls, doors, movers, lights and named places. Every edit can be undone.");
  bind_reading(type);
  bind_header(type);
  type.text<&text>().picture<&picture>().equal<&equal>();
}

}  // namespace meander::script
