// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <filesystem>

#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/item_options.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "world/export_ros_map.hpp"
#include "world/import_world.hpp"
#include "world/world_file.hpp"

namespace meander::script {

/// A pose, or false for none.
struct StartOption {
  bool given = false;
  std::optional<Pose2> pose;
};
template <>
struct Lua<StartOption> {
  static StartOption read(lua_State* L, int index, const Path& path) {
    if (lua_isboolean(L, index) && !lua_toboolean(L, index)) return {true, std::nullopt};
    return {true, Lua<Pose2>::read(L, index, path)};
  }
  static std::string type() { return "{x, y, heading} or false"; }
};

struct HeaderOptions {
  std::optional<std::string> title, note;
  std::optional<Box> bounds;
  StartOption start;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, HeaderOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"title", "", "its name"}, o.title);
  visit(Field{"note", "", "what the world shows, and its source"}, o.note);
  visit(Field{"bounds", "m", "lower left and upper right corner; {{0, 0}, {10, 10}} when left out"}, o.bounds);
  visit(Field{"start", "m, rad", "where robots start; false: nowhere"}, o.start);
}

struct ExportOptions {
  double resolution = 0.05;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ExportOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"resolution", "m", "side of a cell", 0.001, 100}, o.resolution);
}

namespace {

/// Only what is given changes.
Header changed(Header header, const HeaderOptions& options) {
  if (options.title) header.title = *options.title;
  if (options.note) header.note = *options.note;
  if (options.bounds) header.bounds = *options.bounds;
  if (options.start.given) header.start = options.start.pose;
  return header;
}

std::shared_ptr<World> make(const HeaderOptions& options) {
  return std::make_shared<World>(changed(Header{}, options));
}
std::shared_ptr<World> open(const InputFile& file) { return std::make_shared<World>(read_world(file.path)); }
std::shared_ptr<World> from_toml(const std::string& text) { return std::make_shared<World>(world_from_toml(text)); }
std::tuple<std::shared_ptr<World>, std::vector<std::string>> import(const InputFile& file, const ImportOptions& options,
                                                                    const Call& call) {
  ImportOptions all = options;
  all.opens = [&](const std::string& path) { path_to_read(call.L, std::filesystem::absolute(path).string()); };
  Imported imported = import_world(file.path, all, call.work());
  return {std::make_shared<World>(std::move(imported.world)), std::move(imported.report)};
}

void export_ros(const World& world, const OutputFile& file, const ExportOptions& options, const Call& call) {
  path_to_write(call.L, std::filesystem::absolute(file.path).replace_extension(".pgm").string());
  export_ros_map(world, file.path, options.resolution, call.work());
}
void set(World& world, const HeaderOptions& options) { world.set_header(changed(world.header(), options)); }

}  // namespace

void bind_world_module(lua_State* L) {
  Module(L, "meander.world", "Worlds: what stands where.")
      .function<&make>(Doc{.name = "new",
                           .text = "Makes an empty world.",
                           .args = {{"options", "title, bounds and start"}},
                           .returns = "the world",
                           .errors = "bounds that are empty or not finite; a start outside",
                           .example = "w = meander.world.new { title = 'yard', bounds = {{0, 0}, {12, 9}} }"})
      .function<&open>(Doc{.name = "open",
                           .text = "Reads a world file.",
                           .args = {{"path", "a .toml file"}},
                           .returns = "the world",
                           .errors = "no such file; what is wrong in it, with line and key",
                           .example = "w = meander.world.open 'worlds/office.toml'"})
      .function<&from_toml>(Doc{.name = "from_toml",
                                .text = "Reads a world from the text of a world file.",
                                .args = {{"text", "TOML text"}},
                                .returns = "the world",
                                .errors = "what is wrong in it, with line and key",
                                .example = "w = meander.world.from_toml(meander.world.new {}:to_toml())"})
      .function<&import>(
          Doc{.name = "import",
              .text = "Reads other people's maps by suffix: world files, ROS maps (.yaml), pictures of floor "
                      "plans (.png, .pgm, .jpg), BARN tables (.csv), MovingAI maps and ARIA line maps (.map).",
              .args = {{"path", "a .toml, .yaml, .yml, .png, .pgm, .jpg, .jpeg, .bmp, .tif, .tiff, .csv or .map file"},
                       {"options", "how to read it"}},
              .returns = "the world, and a list of lines that say what was done",
              .errors = "no such file; unknown suffix; what is wrong in it",
              .example = "w, report = meander.world.import('worlds/office.toml')"});
  Type<World>(L)
      .method<&export_ros>(
          Doc{.name = "export_ros",
              .text = "Writes a ROS map: a .yaml file and a .pgm picture beside it.",
              .args = {{"path", "the .yaml file"}, {"options", "size of the cells"}},
              .errors = "the files cannot be written",
              .example = "meander.world.new {}:export_ros(os.tmpname() .. '.yaml', { resolution = 0.1 })"})
      .method<&set>(Doc{.name = "set",
                        .text = "Changes title, note, bounds or start; what is not given stays.",
                        .args = {{"options", "what to change"}},
                        .errors = "something would be outside or in the way",
                        .example = "w = meander.world.new {} w:set { title = 'yard', start = {1, 1, 0} }"});
}

}  // namespace meander::script
