// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/objects.hpp"
#include "script/robot_options.hpp"
#include "script/topology_objects.hpp"
#include "topology/route_guide.hpp"
#include "topology/wander.hpp"
#include "topology/whisker_drive.hpp"

namespace meander::script {

using topology::TopologicMap;

struct WhiskersTable {
  Preset<Platform> robot{platform("alice")};
  topology::WhiskerDriveOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WhiskersTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot that it drives"}, o.robot);
  fields(o.options, visit);
}

struct WanderTable {
  Required<std::shared_ptr<TopologicMap>> map;
  topology::WanderOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WanderTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"map", "", "the map that it fills"}, o.map);
  fields(o.options, visit);
}

struct RouteTable {
  Required<std::shared_ptr<TopologicMap>> map;
  Required<int> to;
  topology::RouteGuideOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RouteTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"map", "", "the map whose links are driven"}, o.map);
  visit(Field{"to", "", "number of the place to go to"}, o.to);
  fields(o.options, visit);
}

namespace {

std::shared_ptr<Navigator> whiskers(const WhiskersTable& table) {
  return std::make_shared<Navigator>(topology::whisker_drive(table.robot.value, table.options));
}
std::shared_ptr<Guide> wander(const WanderTable& table) {
  return std::make_shared<Guide>(topology::wander(table.map.value, table.options));
}
std::shared_ptr<Guide> route(const RouteTable& table) {
  return std::make_shared<Guide>(
      topology::route_guide(table.map.value, cell_of(*table.map.value, table.to.value), table.options));
}

}  // namespace

void bind_topology_drive(lua_State* L) {
  Module(L, "meander.topology", "")
      .function<&whiskers>(
          Doc{.name = "whiskers",
              .text = "A navigator for omnidirectional robots: straight on, and along what the whiskers touch.",
              .args = {{"options", "the robot, and when it slides or gives up"}},
              .returns = "the navigator",
              .errors = "a robot without whiskers or whose first is not ahead; one that cannot go sideways",
              .example = "print(meander.topology.whiskers {}.name)"})
      .function<&wander>(Doc{
          .name = "wander",
          .text =
              "A guide that explores: bouncing off, along walls, to where the map has few places. Fills the map. With "
              "revisit.share it also drives to links that contacts speak against, and tries to pass them.",
          .args = {{"options", "the map, how many samples, the seed of its choices, how doubted links are revisited"}},
          .returns = "the guide",
          .errors = "no map; a number out of range",
          .example =
              EXAMPLE_TOPOLOGY "s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { "
                               "map = m, samples = 100, revisit = { share = 0.5 } } } print(m)"})
      .function<&route>(
          Doc{.name = "route",
              .text = "A guide over the links of a map to one of its places. It believes to be there only when the "
                      "senses agree.",
              .args = {{"options", "the map, the place, and how it drives"}},
              .returns = "the guide",
              .errors = "no map; no such place; a number out of range",
              .example = EXAMPLE_TOPOLOGY "print(s:drive { navigator = meander.topology.whiskers {}, guide = "
                                          "meander.topology.route { map = m, to = m.links[1].a } }.success)"});
}

}  // namespace meander::script
