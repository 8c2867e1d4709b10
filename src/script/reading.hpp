// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "render/draw_list.hpp"
#include "script/numbers.hpp"
#include "script/objects.hpp"
#include "script/robot_options.hpp"

namespace meander::script {

/// One scan of a sonar ring, taken standing still.
struct Reading {
  std::shared_ptr<const World> world;
  RingLayout layout;
  SonarOptions sonar;
  Pose2 pose;
  double body_radius = 0;
  std::vector<double> ranges;
};

inline std::size_t native_size(const Reading& reading) {
  return sizeof(Reading) + meander::native_size(*reading.world);
}

struct ScanTable {
  Required<std::shared_ptr<World>> world;
  std::optional<PoseOption> pose;
  Preset<SonarOptions> sonar;
  Preset<Platform> robot;
  std::uint64_t seed = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ScanTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"world", "", "what stands around"}, o.world);
  visit(Field{"pose", "m, rad", "where the robot stands; the world's start when left out"}, o.pose);
  visit(Field{"sonar", "", "model of the sonars, by name or in detail"}, o.sonar);
  visit(Field{"robot", "", "kind of robot: where its sonars sit"}, o.robot);
  visit(Field{"seed", "", "seed of the noise"}, o.seed);
}

struct RayTable {
  Required<std::shared_ptr<World>> world;
  Required<Vec2> from;
  double heading = 0;
  double range = 1000;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RayTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"world", "", "what stands around"}, o.world);
  visit(Field{"from", "m", "where the ray begins"}, o.from);
  visit(Field{"heading", "rad", "where it points"}, o.heading);
  visit(Field{"range", "m", "how far it reaches", 0, 1e6}, o.range);
}

template <>
struct ObjectName<Reading> {
  static constexpr const char* value = "reading";
};

Reading scan(const ScanTable& table);
/// Range, the thing hit and the point hit; nothing when the ray meets nothing.
std::tuple<std::optional<double>, std::optional<Thing>, std::optional<Vec2>> ray(const RayTable& table);
DrawList picture_of(const Reading& reading);

}  // namespace meander::script
