// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <cctype>

#include "base/atomic_file.hpp"
#include "base/text_file.hpp"
#include "render/draw_topology.hpp"
#include "render/draw_world.hpp"
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/numbers.hpp"
#include "script/objects.hpp"
#include "script/picture.hpp"
#include "script/robot_options.hpp"
#include "script/topology_objects.hpp"
#include "topology/map_export.hpp"
#include "topology/map_text.hpp"
#include "topology/route.hpp"

namespace meander::script {

using topology::TopologicMap;

struct TopologicMapTable {
  Preset<Platform> robot{platform("alice")};
  double whisker_reach = WhiskerOptions{}.reach;
  topology::TopologicMapOptions map;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TopologicMapTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot whose whiskers and light sensors are read"}, o.robot);
  visit(Field{"whisker_reach", "m", "length of its whiskers", 0, 10}, o.whisker_reach);
  fields(o.map, visit);
}

/// A place of the map.
struct PlaceTable {
  int number = 0;
  std::string serial;
  Vec2 position{0, 0};
  std::uint64_t born = 0, hits = 0;
  int links = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlaceTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"number", "", "its number; numbers of removed places are used again"}, o.number);
  visit(Field{"serial", "", "its serial number, as text; never used again"}, o.serial);
  visit(Field{"position", "m", "in the frame of the map"}, o.position);
  visit(Field{"born", "", "sample in which it was made"}, o.born);
  visit(Field{"hits", "", "how often it won"}, o.hits);
  visit(Field{"links", "", "how many it has"}, o.links);
}

struct PlaceLinkTable {
  int a = 0, b = 0;
  double weight = 0, doubt = 0;
  bool suspended = false;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PlaceLinkTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"a", "", "number of one place"}, o.a);
  visit(Field{"b", "", "number of the other, larger"}, o.b);
  visit(Field{"weight", "", "confidence, 1 when just driven"}, o.weight);
  visit(Field{"doubt", "", "contacts that speak against it"}, o.doubt);
  visit(Field{"suspended", "", "is it believed to be blocked?"}, o.suspended);
}

namespace {

using Map = std::shared_ptr<TopologicMap>;

Map make(const TopologicMapTable& table) {
  return std::make_shared<TopologicMap>(table.map, topology::sense_suite(table.robot.value, table.whisker_reach));
}
constexpr std::size_t kMostBytes = std::size_t{1} << 32;
Map open(const InputFile& file) {
  return std::make_shared<TopologicMap>(topology::read_map_text(read_text_file(file.path, kMostBytes), file.path));
}

void save(const TopologicMap& map, const OutputFile& file) {
  std::string suffix = file.path.substr(std::min(file.path.find_last_of('.'), file.path.size()));
  for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  write_file_atomically(file.path, suffix == ".dot"       ? topology::to_dot(map.net().cells())
                                   : suffix == ".graphml" ? topology::to_graphml(map.net().cells())
                                                          : topology::map_text(map));
}
std::string source(const TopologicMap& map) { return topology::map_text(map); }
Map copy(const TopologicMap& map) { return std::make_shared<TopologicMap>(map); }

std::vector<PlaceTable> places(const TopologicMap& map) {
  std::vector<PlaceTable> all;
  const topology::CellPool& cells = map.net().cells();
  for (int cell = 0; cell < cells.slots(); ++cell)
    if (cells[cell].alive())
      all.push_back({cell + 1, fmt::format("{}", cells[cell].serial), cells[cell].position,
                     static_cast<std::uint64_t>(cells[cell].born), static_cast<std::uint64_t>(cells[cell].hits),
                     static_cast<int>(cells[cell].links.size())});
  return all;
}
std::vector<PlaceLinkTable> links(const TopologicMap& map) {
  std::vector<PlaceLinkTable> all;
  const topology::CellPool& cells = map.net().cells();
  for (int cell = 0; cell < cells.slots(); ++cell)
    for (const topology::Link& link : cells[cell].links)
      if (cell < link.to) all.push_back({cell + 1, link.to + 1, link.weight, link.doubt, link.suspended});
  return all;
}
void set_link(TopologicMap& map, int a, int b, const std::optional<bool>& suspended) {
  topology::CellPool& cells = map.net().cells();
  const int from = cell_of(map, a), to = cell_of(map, b);
  const topology::Link* link = cells.find(from, to);
  if (!link) fail("no link between places {} and {}", a, b);
  topology::Link changed = *link;
  changed.suspended = suspended.value_or(true);
  changed.doubt = changed.suspended ? std::max(link->doubt, map.options().doubt.suspend) : 0;
  cells.connect(from, to, changed);
}
std::optional<int> nearest(const TopologicMap& map, const Vec2& at) {
  const int cell = topology::nearest_place(map.net().cells(), at);
  return cell < 0 ? std::nullopt : std::optional(cell + 1);
}
std::optional<int> alike(const TopologicMap& map) {
  if (map.samples() == 0) fail("the map has not taken in any sample yet");
  const int cell = topology::most_alike(map.net(), map.situation().senses);
  return cell < 0 ? std::nullopt : std::optional(cell + 1);
}
std::optional<std::vector<int>> way(const TopologicMap& map, int from, int to,
                                    const std::optional<topology::RouteOptions>& options) {
  auto found = topology::route(map.net().cells(), cell_of(map, from), cell_of(map, to),
                               options.value_or(topology::RouteOptions{}));
  if (found)
    for (int& cell : *found) ++cell;
  return found;
}
std::optional<int> winner(const TopologicMap& map) {
  return map.net().winner() < 0 ? std::nullopt : std::optional(map.net().winner() + 1);
}
std::uint64_t samples(const TopologicMap& map) { return static_cast<std::uint64_t>(map.samples()); }
DrawList picture(const TopologicMap& map) { return draw_topology(map); }
DrawList over(const TopologicMap& map, const World& world) {
  DrawList list = draw_world(world);
  draw_topology(list, map, theme(Background::light));
  return list;
}
std::string text(const TopologicMap& map) {
  return fmt::format("topologic_map: {} places, {} links, {} samples", map.net().cells().size(), links(map).size(),
                     map.samples());
}
int length(const TopologicMap& map) { return map.net().cells().size(); }

void bind_learning(Type<TopologicMap>& type) {
  type.method<&TopologicMap::step>(Doc{.name = "step",
                                       .text = "Takes in one sample and learns.",
                                       .args = {{"observation", "what the robot senses"}},
                                       .errors = "other numbers of whiskers or light sensors",
                                       .example = EXAMPLE_TOPOLOGY "m:step(s.observation) print(m.samples)"})
      .method<&TopologicMap::follow>(
          Doc{.name = "follow",
              .text = "Takes in one sample without learning: the robot only stays localised, and links are judged.",
              .args = {{"observation", "what the robot senses"}},
              .errors = "other numbers of whiskers or light sensors",
              .example = EXAMPLE_TOPOLOGY "m:follow(s.observation) print(m.pose)"})
      .method<&TopologicMap::begin>(
          Doc{.name = "begin",
              .text = "A new run begins, of another simulation or another day: no link to the last place, and odometry "
                      "that begins anew.",
              .args = {{"pose", "where the robot is now, in the frame of the map; where it was last", "m, rad"}},
              .errors = "a number beyond 1e6",
              .example = EXAMPLE_TOPOLOGY "m:begin {2, 1, 0} print(m.pose, m.winner)"})
      .method<&TopologicMap::shift>(Doc{.name = "shift",
                                        .text =
                                            "Moves where the robot believes to be. What comes next is not linked to "
                                            "what was.",
                                        .args = {{"by", "how far", "m"}},
                                        .errors = "a number beyond 1e6",
                                        .example = EXAMPLE_TOPOLOGY "m:shift {0.1, 0} print(m.pose)"})
      .method<&set_link>(
          Doc{.name = "suspend",
              .text = "Suspends a link, or brings it back.",
              .args = {{"a", "number of a place"},
                       {"b", "number of a place linked to it"},
                       {"suspended", "false brings it back"}},
              .errors = "no such place or link",
              .example = EXAMPLE_TOPOLOGY "l = m.links[1] m:suspend(l.a, l.b) print(m.links[1].suspended)"})
      .method<&copy>(Doc{.name = "copy",
                         .text = "An independent copy.",
                         .returns = "the copy",
                         .example = EXAMPLE_TOPOLOGY "c = m:copy() print(#c == #m)"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes it: .dot and .graphml for other programs, else for meander.topology.open.",
                         .args = {{"path", "the file"}},
                         .errors = "the file cannot be written",
                         .example = EXAMPLE_TOPOLOGY "m:save(os.tmpname() .. '.graphml')"});
}

void bind_looking(Type<TopologicMap>& type) {
  type.method<&nearest>(Doc{.name = "nearest",
                            .text = "The place nearest to a position.",
                            .args = {{"position", "in the frame of the map", "m"}},
                            .returns = "its number, or nil in an empty map",
                            .example = EXAMPLE_TOPOLOGY "print(m:nearest {1, 1})"})
      .method<&alike>(Doc{.name = "alike",
                          .text = "The place whose senses are most like those of now, wherever it is.",
                          .returns = "its number, or nil in an empty map",
                          .errors = "a map without samples",
                          .example = EXAMPLE_TOPOLOGY "print(m:alike())"})
      .method<&way>(Doc{.name = "way",
                        .text = "The cheapest way over the links from one place to another.",
                        .args = {{"from", "number of a place"}, {"to", "the same"}, {"options", "what links cost"}},
                        .returns = "numbers of the places on the way, or nil when there is none",
                        .errors = "no such place",
                        .example = EXAMPLE_TOPOLOGY "print(#m:way(m.winner, m.links[1].a))"})
      .method<&over>(Doc{.name = "over",
                         .text = "The picture of a world with the map over it.",
                         .args = {{"world", "in whose frame the map began"}},
                         .returns = "the picture, for show and save",
                         .example = EXAMPLE_TOPOLOGY "show(m:over(s.world))"})
      .property<&places>(PropertyDoc{.name = "places",
                                     .text = "All places: {number, serial, position, born, hits, links}.",
                                     .example = EXAMPLE_TOPOLOGY "print(m.places[1].position.x)"})
      .property<&links>(PropertyDoc{.name = "links",
                                    .text = "All links: {a, b, weight, doubt, suspended}.",
                                    .example = EXAMPLE_TOPOLOGY "print(m.links[1].weight)"})
      .property<&winner>(PropertyDoc{.name = "winner",
                                     .text = "Number of the place that won last; nil: none yet.",
                                     .example = EXAMPLE_TOPOLOGY "print(m.winner)"})
      .property<&TopologicMap::pose>(PropertyDoc{.name = "pose",
                                                 .text = "Where the robot believes to be, in the frame of the map.",
                                                 .unit = "m, rad",
                                                 .example = EXAMPLE_TOPOLOGY "print(m.pose)"})
      .property<&samples>(
          PropertyDoc{.name = "samples", .text = "Samples so far.", .example = EXAMPLE_TOPOLOGY "print(m.samples)"})
      .property<&source>(PropertyDoc{
          .name = "source", .text = "It as text, as save writes it.", .example = EXAMPLE_TOPOLOGY "print(#m.source)"})
      .picture<&picture>()
      .length<&length>()
      .text<&text>();
}

}  // namespace

void bind_topology(lua_State* L) {
  Module(L, "meander.topology", "Qualitative topologic maps: places and links from whiskers and light.")
      .function<&make>(
          Doc{.name = "map",
              .text = "A new, empty topologic map.",
              .args = {{"options", "the robot, and how the map learns"}},
              .returns = "the map",
              .errors = "a robot without whiskers, or whose rings do not begin ahead; a number out of range",
              .example = "print(meander.topology.map { net = { insert_distance = 1.2 } })"})
      .function<&open>(Doc{.name = "open",
                           .text = "Reads a map that map:save wrote; it goes on exactly as the other would.",
                           .args = {{"path", "the file"}},
                           .returns = "the map",
                           .errors = "the file cannot be read, or is none",
                           .example = EXAMPLE_TOPOLOGY "f = os.tmpname() m:save(f) print(meander.topology.open(f))"});
  Type<TopologicMap> type(L, "Places with what was sensed there, linked where the robot went from one to the other.");
  bind_learning(type);
  bind_looking(type);
}

}  // namespace meander::script
