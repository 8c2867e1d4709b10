// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_navigator.hpp"
#include "render/draw_polar.hpp"
#include "script/bind.hpp"
#include "script/example_text.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/objects.hpp"
#include "script/picture.hpp"
#include "script/polar_own.hpp"
#include "script/robot_options.hpp"

namespace meander::script {

struct PolarTable {
  Preset<Platform> robot;
  PolarOptions options;
  PolarOwnTable own;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot that it drives"}, o.robot);
  fields(o.options, visit);
  visit(Field{"own", "", "parts of one's own, as functions"}, o.own);
}

/// Where the navigator went, in the odometry frame.
struct PolarSubgoalView {
  double x = 0, y = 0;
  int ring = 1, sector = 1;
  bool exact = false;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarSubgoalView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"x", "m", "in the odometry frame"}, o.x);
  visit(Field{"y", "m", "in the odometry frame"}, o.y);
  visit(Field{"ring", "", "of its unit, the centre is 1"}, o.ring);
  visit(Field{"sector", "", "of its unit, the target's is 1"}, o.sector);
  visit(Field{"exact", "", "the target itself"}, o.exact);
}

/// What the chosen command costs, term by term.
struct PolarCostView {
  double distance = 0, heading = 0, hard = 0, soft = 0, speed = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarCostView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"distance", "m", "left to the subgoal"}, o.distance);
  visit(Field{"heading", "m", "not facing it"}, o.heading);
  visit(Field{"hard", "m", "nearer to something than the hard margin"}, o.hard);
  visit(Field{"soft", "m", "in the slow zone"}, o.soft);
  visit(Field{"speed", "m", "fast there"}, o.speed);
}

/// A polar navigator's last cycle.
struct PolarLook {
  Pose2 frame, predicted;
  int rings = 0, sectors = 0;
  double target = 0;
  int target_ring = 1;
  std::vector<double> radii, bearings;
  Matrix obstructed, activation;
  double residual = 0;
  std::optional<PolarSubgoalView> subgoal;
  PolarCandidateView chosen;
  PolarCostView cost;
  std::vector<Vec2> points, memory;
  int latency = 0, traps = 0;
  bool escaping = false;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarLook>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"frame", "m, rad", "pose of the map in the odometry frame: sector 1 points along its heading"}, o.frame);
  visit(Field{"predicted", "m, rad", "pose when the command takes effect"}, o.predicted);
  visit(Field{"rings", "", "how many there are"}, o.rings);
  visit(Field{"sectors", "", "how many there are"}, o.sectors);
  visit(Field{"target", "m", "distance of the target"}, o.target);
  visit(Field{"target_ring", "", "of its unit"}, o.target_ring);
  visit(Field{"radii", "m", "of the rings"}, o.radii);
  visit(Field{"bearings", "rad", "of the sectors, in the map's frame"}, o.bearings);
  visit(Field{"obstructed", "", "1 where a unit is obstructed, a row per ring"}, o.obstructed);
  visit(Field{"activation", "", "decadic logarithm, a row per ring; -400 where there is none"}, o.activation);
  visit(Field{"residual", "", "how far from the equilibrium: the largest relative error"}, o.residual);
  visit(Field{"subgoal", "m", "chosen; nil: no way"}, o.subgoal);
  visit(Field{"chosen", "", "the candidate chosen by the motion control"}, o.chosen);
  visit(Field{"cost", "m", "what that one costs, by the navigator's own objective"}, o.cost);
  visit(Field{"points", "m", "what is mapped, in the odometry frame"}, o.points);
  visit(Field{"memory", "m", "what is remembered, in the odometry frame"}, o.memory);
  visit(Field{"latency", "", "cycles until commands take effect"}, o.latency);
  visit(Field{"traps", "", "how often it was trapped so far"}, o.traps);
  visit(Field{"escaping", "", "on the way to a temporary target"}, o.escaping);
}

namespace {

std::shared_ptr<Navigator> polar(const PolarTable& table) {
  return std::make_shared<Navigator>(polar_navigator(table.robot.value, table.options, polar_parts(table.own)));
}

Matrix obstructed_units(const PolarNavigator& polar) {
  const PolarLayout& layout = polar.layout();
  auto cells = std::make_shared<std::vector<float>>();
  for (int ring = 0; ring < layout.rings(); ++ring)
    for (int sector = 0; sector < layout.sectors(); ++sector)
      cells->push_back(polar.obstructed().test(ring, sector) ? 1.0F : 0.0F);
  return {std::move(cells), static_cast<std::size_t>(layout.rings()), static_cast<std::size_t>(layout.sectors())};
}

PolarLook look(const PolarNavigator& polar) {
  PolarLook look;
  look.frame = polar.odometry_from_map();
  look.predicted = polar.predicted().pose;
  look.rings = polar.layout().rings();
  look.sectors = polar.layout().sectors();
  look.target = polar.target().x();
  look.target_ring = polar.target_ring() + 1;
  look.radii = polar.layout().radii();
  look.bearings = sector_bearings(polar.layout());
  look.obstructed = obstructed_units(polar);
  look.activation = log_activation(polar.layout(), polar.solver());
  look.residual = polar.solver().residual(polar.obstructed());
  if (const auto& subgoal = polar.subgoal()) {
    const Vec2 at = look.frame * subgoal->position;
    look.subgoal = {at.x(), at.y(), subgoal->ring + 1, subgoal->sector + 1, subgoal->exact};
  }
  look.chosen = candidate_view(polar.control().chosen());
  const MotionCost cost = polar.control().cost(polar.control().chosen());
  look.cost = {cost.distance, cost.heading, cost.hard, cost.soft, cost.speed};
  for (const MappedPoint& point : polar.points()) look.points.push_back(look.frame * point.position);
  for (int age = 0; age < polar.memory().scans(); ++age)
    for (const MemoryPoint& point : polar.memory().scan(age)) look.memory.push_back(point.position);
  look.latency = polar.predictor().latency();
  look.traps = polar.trap().traps();
  look.escaping = polar.trap().temporary().has_value();
  return look;
}

std::shared_ptr<const PolarNavigator> inside(const Navigator& navigator) {
  auto inside = polar_inside(navigator);
  if (!inside) fail("navigator \"{}\": only polar navigators can be looked into", navigator.name);
  if (!inside->mapped()) fail("navigator \"{}\" has not driven yet: there is no map to look into", navigator.name);
  return inside;
}

PolarLook inspect(const Navigator& navigator) { return look(*inside(navigator)); }

DrawList picture(const Navigator& navigator) {
  const auto polar = inside(navigator);
  const Platform& platform = polar->platform();
  return draw_polar(*polar, {.radius = platform.body.radius,
                             .ring = platform.sonar,
                             .half_cone = SonarOptions{}.half_cone,
                             .range_max = polar->options().memory.range_max});
}

}  // namespace

void bind_polar(lua_State* L) {
  Module(L, "meander.polar", "")
      .function<&polar>(
          Doc{.name = "navigator",
              .text = "The polar neural map navigator: sonar memory, prediction, polar map, motion control.",
              .args = {{"options", "the robot it drives, and its parts"}},
              .returns = "the navigator",
              .errors = "a number out of range; own weights without a stable equilibrium",
              .example = "print(meander.polar.navigator { map = { rings = 100, sectors = 32 } })"});
  Type<Navigator>(L).picture<&picture>().method<&inspect>(
      Doc{.name = "inspect",
          .text = "What the last cycle of a polar navigator was like: map, activation, memory, choice.",
          .returns = "table of what it had before it",
          .errors = "another kind of navigator; one that has not driven yet",
          .example =
              EXAMPLE_SIM "n = meander.polar.navigator {} n:step(s.observation, {4, 2}) print(n:inspect().subgoal.x)"});
}

}  // namespace meander::script
