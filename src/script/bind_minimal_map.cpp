// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/atomic_file.hpp"
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/objects.hpp"
#include "script/topology_objects.hpp"
#include "topology/quantised_map.hpp"

#define EXAMPLE_MINIMAL EXAMPLE_TOPOLOGY "k = meander.topology.minimal { map = m } k:step(m) "

namespace meander::script {

using topology::MinimalMap;
using topology::TopologicMap;

struct MinimalTable {
  Required<std::shared_ptr<TopologicMap>> map;
  topology::MinimalOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MinimalTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"map", "", "the map that localises the robot, whose options it takes"}, o.map);
  fields(o.options, visit);
}

struct MinimalSizes {
  int geometry = 0, light = 0, touch = 0;
  double bytes = 0, bytes_of_map = 0, bytes_quantised = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MinimalSizes>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"geometry", "", "places of the geometry net"}, o.geometry);
  visit(Field{"light", "", "cells of the light net"}, o.light);
  visit(Field{"touch", "", "cells of the touch net"}, o.touch);
  visit(Field{"bytes", "", "of the minimal model, numbers of four bytes"}, o.bytes);
  visit(Field{"bytes_of_map", "", "of the whole map, the same"}, o.bytes_of_map);
  visit(Field{"bytes_quantised", "", "of the minimal model with one byte a value"}, o.bytes_quantised);
}

namespace {

constexpr double kAnywhere = 1e6;  ///< scale of the position when it shall not count [m]

std::shared_ptr<MinimalMap> make(const MinimalTable& table) {
  const TopologicMap& map = *table.map.value;
  validate(table.options);
  return std::make_shared<MinimalMap>(table.options, map.options().net, map.options().scales, map.whiskers(),
                                      map.lights());
}
void check_same_robot(const MinimalMap& minimal, const TopologicMap& map) {
  const int touch = minimal.touch().metric().touch(), light = minimal.light().metric().light();
  if (map.whiskers() != touch || map.lights() != light)
    fail("a map of the same robot expected, {} whiskers and {} light sensors; got one of {} and {}", touch, light,
         map.whiskers(), map.lights());
}
void check_situation(const MinimalMap& minimal, const TopologicMap& map) {
  check_same_robot(minimal, map);
  if (map.samples() == 0) fail("the map has not taken in any sample yet");
}
void step(MinimalMap& minimal, const TopologicMap& map) {
  check_situation(minimal, map);
  for (int k = 0; k < map.options().presentations; ++k) minimal.present(map.situation(), map.samples());
}
MinimalSizes sizes(const MinimalMap& minimal, const TopologicMap& map) {
  check_same_robot(minimal, map);
  return {minimal.geometry().cells().size(),
          minimal.light().cells().size(),
          minimal.touch().cells().size(),
          static_cast<double>(map_bytes(minimal, 4)),
          static_cast<double>(map_bytes(map.net(), 4)),
          static_cast<double>(quantised(minimal).bytes())};
}
std::optional<Vec2> recognise(const MinimalMap& minimal, const TopologicMap& map, const std::optional<bool>& quantise,
                              const std::optional<bool>& senses_alone) {
  check_situation(minimal, map);
  const topology::Situation now = map.situation();
  topology::Scales scales = map.options().scales;
  if (senses_alone.value_or(false)) scales.position = kAnywhere;
  if (!quantise.value_or(false)) {
    const int place = topology::recognise(minimal, now, scales);
    return place < 0 ? std::nullopt : std::optional(minimal.geometry().cells()[place].position);
  }
  const topology::QuantisedMap small = quantised(minimal);
  const int place = topology::recognise(small, now, scales);
  return place < 0 ? std::nullopt : std::optional(position_of(small, place));
}
void save_c(const MinimalMap& minimal, const OutputFile& file, const std::optional<std::string>& name) {
  write_file_atomically(file.path, c_source(quantised(minimal), name.value_or("meander_map")));
}
std::string text(const MinimalMap& minimal) {
  return fmt::format("minimal_map: {} places, {} lights, {} touches", minimal.geometry().cells().size(),
                     minimal.light().cells().size(), minimal.touch().cells().size());
}

}  // namespace

void bind_minimal_map(lua_State* L) {
  Module(L, "meander.topology", "")
      .function<&make>(
          Doc{.name = "minimal",
              .text = "The minimal model beside a topologic map: three nets that share lights and touches.",
              .args = {{"options", "the map that localises it, and how the nets differ from its"}},
              .returns = "the minimal map",
              .errors = "no map; a number out of range",
              .example = EXAMPLE_MINIMAL "print(k)"});
  Type<MinimalMap>(L, "Places that tell by links which of a few lights and touches is theirs.")
      .method<&step>(Doc{.name = "step",
                         .text = "Takes in the situation that the map has now.",
                         .args = {{"map", "the map that localises it"}},
                         .errors = "a map of another robot, or one without samples",
                         .example = EXAMPLE_MINIMAL "k:step(m)"})
      .method<&sizes>(Doc{.name = "sizes",
                          .text = "How large the nets are, and how many bytes they take.",
                          .args = {{"map", "the whole map to compare with"}},
                          .returns = "{geometry, light, touch, bytes, bytes_of_map, bytes_quantised}",
                          .errors = "a map of another robot; more than 254 lights or touches",
                          .example = EXAMPLE_MINIMAL "print(k:sizes(m).bytes)"})
      .method<&recognise>(
          Doc{.name = "recognise",
              .text = "Where the model takes the map's situation of now to be.",
              .args = {{"map", "the map that localises it"},
                       {"quantised", "with one byte a value"},
                       {"senses_alone", "by touch and light, wherever the robot believes to be"}},
              .returns = "the position of that place, or nil in an empty model",
              .errors = "a map of another robot, or one without samples; more than 254 lights or touches, when "
                        "quantised",
              .example = EXAMPLE_MINIMAL "print(k:recognise(m, true).x)"})
      .method<&save_c>(Doc{.name = "save_c",
                           .text = "Writes the model with one byte a value as a C header, for micro-controllers.",
                           .args = {{"path", "the file"}, {"name", "what its arrays begin with"}},
                           .errors = "more than 254 lights or touches; a name that is no C identifier",
                           .example = EXAMPLE_MINIMAL "k:save_c(os.tmpname())"})
      .text<&text>();
}

}  // namespace meander::script
