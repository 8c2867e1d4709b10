// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/item_options.hpp"
#include "script/kit_options.hpp"
#include "sim/sim.hpp"

namespace meander::script {

template <>
struct PresetSource<Platform> {
  static Platform get(const std::string& name) { return platform(name); }
  static std::vector<std::string> names() { return platform_names(); }
};
template <>
struct PresetSource<SonarOptions> {
  static SonarOptions get(const std::string& name) { return sonar_preset(name); }
  static std::vector<std::string> names() { return sonar_preset_names(); }
};

template <>
struct PresetSource<DriftOptions> {
  static DriftOptions get(const std::string& name) { return drift_preset(name); }
  static std::vector<std::string> names() { return drift_preset_names(); }
};

/// A pose, or the name of a place.
struct PoseOption {
  Pose2 pose;
  std::optional<ThingRef> place;
  Pose2 in(const World& world) const;
};
template <>
struct Lua<PoseOption> {
  static PoseOption read(lua_State* L, int index, const Path& path);
  static std::string type() { return "{x, y, heading} or place"; }
};

/// One robot of a simulation.
struct RobotTable {
  Preset<Platform> robot;
  Preset<SonarOptions> sonar;
  Preset<DriftOptions> drift;
  WhiskerOptions whisker;
  LightSensorOptions light;
  std::optional<PoseOption> start;
};
template <class Options, class Visitor>
void robot_fields(Options& o, Visitor&& visit) {
  visit(Field{"robot", "", "kind of robot, by name or in detail"}, o.robot);
  visit(Field{"sonar", "", "model of the sonars, by name or in detail"}, o.sonar);
  visit(Field{"drift", "", "errors of the odometry, by name or in detail; none when left out"}, o.drift);
  visit(Field{"whisker", "", "model of the whiskers, for platforms that have some"}, o.whisker);
  visit(Field{"light", "", "model of the light sensors, for platforms that have some"}, o.light);
  visit(Field{"start", "m, rad", "where it starts; the world's start when left out"}, o.start);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, RobotTable>
void fields(Options& o, Visitor&& visit) { robot_fields(o, visit); }

RobotOptions robot_options(const RobotTable& table, const World& world);

}  // namespace meander::script
