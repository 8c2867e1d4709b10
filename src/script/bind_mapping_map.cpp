// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/map_file.hpp"
#include "mapping/sonar_map.hpp"
#include "render/draw_map.hpp"
#include "script/bind.hpp"
#include "script/example_text.hpp"
#include "script/file_access.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/map_object.hpp"
#include "script/numbers.hpp"
#include "script/objects.hpp"
#include "script/picture.hpp"
#include "script/robot_options.hpp"

/// A map `m` that has taken in one scan of a simulation `s`.
#define EXAMPLE_MAP                                                                                                    \
  "s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } } m = meander.mapping.map { model = 'elfes' " \
  "} m:update(s.observation) "

namespace meander::script {

struct MapTable {
  MapChoice choice;
  Preset<Platform> robot;
  LocalMapOptions local;
  bool global = true;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.choice, visit);
  visit(Field{"robot", "", "kind of robot whose sonars are read"}, o.robot);
  fields(o.local, visit);
  visit(Field{"global", "", "keep a map of everywhere, too"}, o.global);
}

namespace {

std::shared_ptr<SonarMap> make(const MapTable& table) {
  const Platform& platform = table.robot.value;
  return std::make_shared<SonarMap>(platform, table.choice.model(platform), table.local, table.global);
}

/// A map that grows hangs more on its userdata than when it was made.
void update(SonarMap& map, const Observation& observation, const Call& call) {
  const std::size_t before = map.bytes();
  map.update(observation);
  if (map.bytes() > before) account(call.L, map.bytes() - before);
}

MapPart part_of(const SonarMap& map, const std::optional<MapPart>& part) {
  return part.value_or(map.global() ? MapPart::global : MapPart::local);
}
double probability(const SonarMap& map, double x, double y) { return map.probability({x, y}); }

Matrix matrix(const SonarMap& map, const std::optional<MapPart>& part) {
  const Grid<float> grid = map.probabilities(part_of(map, part));
  return {std::make_shared<std::vector<float>>(grid.cells()), static_cast<std::size_t>(grid.height()),
          static_cast<std::size_t>(grid.width())};
}
Box box_of(const Grid<float>& grid) {
  const Vec2 low = grid.frame.origin.position();
  return {low, low + grid.frame.resolution * Vec2(grid.width(), grid.height())};
}
Box bounds(const SonarMap& map, const std::optional<MapPart>& part) {
  return box_of(map.probabilities(part_of(map, part)));
}
void save(const SonarMap& map, const OutputFile& file, const std::optional<MapPart>& part) {
  save_map(map.probabilities(part_of(map, part)), file.path);
}
std::string model_name(const SonarMap& map) { return map.local().model().name; }
std::string fusion_name(const SonarMap& map) { return to_string(map.local().options().fusion.rule); }
int size(const SonarMap& map) { return map.local().options().size; }
double resolution(const SonarMap& map) { return map.local().options().resolution; }
std::string text(const SonarMap& map) {
  return fmt::format("map: model {}, fusion {}, {} scans, window of {} x {} cells of {} m{}", model_name(map),
                     fusion_name(map), map.scans(), size(map), size(map), resolution(map),
                     map.global() ? "" : ", no global map");
}

DrawList part_picture(const SonarMap& map, const std::optional<MapPart>& part) {
  if (map.scans() == 0) fail("the map is empty: it has not taken in any scan yet");
  const MapPart shown = part_of(map, part);
  const auto window =
      shown == MapPart::global ? std::optional(box_of(map.probabilities(MapPart::local))) : std::nullopt;
  return draw_map(map.probabilities(shown), window, Disc{map.robot().position(), map.robot_radius()},
                  map.robot().heading);
}
DrawList picture(const SonarMap& map) { return part_picture(map, std::nullopt); }

void bind_methods(lua_State* L) {
  Type<SonarMap>(L, "A local grid map that slides with the robot, and the map of everywhere that it feeds.")
      .method<&update>(Doc{.name = "update",
                           .text = "Takes in one scan.",
                           .args = {{"observation", "what the robot sees"}},
                           .errors = "readings of another ring; a pose that is no place; a full global map",
                           .example = EXAMPLE_MAP "print(m.scans)"})
      .method<&probability>(Doc{.name = "probability",
                                .text = "How probably a place is occupied; 0.5: unknown. By the local map where that "
                                        "knows something, else by the global map.",
                                .args = {{"x", "in the odometry frame", "m"}, {"y", "the same", "m"}},
                                .returns = "the probability",
                                .example = EXAMPLE_MAP "print(m:probability(2, 2))"})
      .method<&matrix>(Doc{.name = "matrix",
                           .text = "A copy of the probabilities, the row of the least y first.",
                           .args = {{"part", "'local' or 'global'; the global map where there is one"}},
                           .returns = "the probabilities",
                           .errors = "there is no global map",
                           .example = EXAMPLE_MAP "print(m:matrix 'local')"})
      .method<&bounds>(Doc{.name = "bounds",
                           .text = "Where the matrix of the same part lies, in the odometry frame.",
                           .args = {{"part", "'local' or 'global'; the global map where there is one"}},
                           .returns = "its corners [m]",
                           .errors = "there is no global map",
                           .example = EXAMPLE_MAP "print(m:bounds('local')[1].x)"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes a ROS map (.yaml and the .pgm beside it: free, unknown, occupied), which "
                                 "meander.world.import reads again, or the shades alone (.pgm, .png).",
                         .args = {{"path", "a name with the suffix .yaml, .pgm or .png"},
                                  {"part", "'local' or 'global'; the global map where there is one"}},
                         .errors = "another suffix; an empty map; a file that cannot be written",
                         .example = EXAMPLE_MAP "m:save('map.yaml')"})
      .method<&part_picture>(Doc{.name = "picture",
                                 .text = "A picture of one part; show(map) draws the global map where there is one.",
                                 .args = {{"part", "'local' or 'global'"}},
                                 .returns = "the picture",
                                 .errors = "an empty map; there is no global map",
                                 .example = EXAMPLE_MAP "print(m:picture 'local')"})
      .method<&SonarMap::clear>(
          Doc{.name = "clear", .text = "Forgets everything.", .example = EXAMPLE_MAP "m:clear() print(m.scans)"});
}

}  // namespace

void bind_mapping_map(lua_State* L) {
  Module(L, "meander.mapping", "Sonar readings to grid maps: sensor models, networks, fusion, local and global maps.")
      .function<&make>(Doc{.name = "map",
                           .text = "A new, empty map: a local window that slides with the robot, and a global map.",
                           .args = {{"options", "the sensor model, the robot, the fusion, size and cells"}},
                           .returns = "the map",
                           .errors = "an unknown model; a number out of range",
                           .example = "print(meander.mapping.map { model = 'elfes', fusion = 'bayes' })"})
      .function<&sonar_model_names>(Doc{.name = "models",
                                        .text = "The names of the sensor models.",
                                        .returns = "list of names",
                                        .example = "print(table.concat(meander.mapping.models(), ' '))"});
  bind_methods(L);
  Type<SonarMap>(L)
      .property<&model_name>(
          PropertyDoc{.name = "model", .text = "Name of its sensor model.", .example = EXAMPLE_MAP "print(m.model)"})
      .property<&fusion_name>(
          PropertyDoc{.name = "fusion", .text = "'viewbin' or 'bayes'.", .example = EXAMPLE_MAP "print(m.fusion)"})
      .property<&SonarMap::scans>(
          PropertyDoc{.name = "scans", .text = "How many it has taken in.", .example = EXAMPLE_MAP "print(m.scans)"})
      .property<&size>(PropertyDoc{
          .name = "size", .text = "Cells along a side of the window.", .example = EXAMPLE_MAP "print(m.size)"})
      .property<&resolution>(PropertyDoc{
          .name = "resolution", .text = "Side of a cell.", .unit = "m", .example = EXAMPLE_MAP "print(m.resolution)"})
      .text<&text>()
      .picture<&picture>();
}

}  // namespace meander::script
