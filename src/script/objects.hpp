// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "robot/contracts.hpp"
#include "script/kit_object.hpp"
#include "sim/sim.hpp"
#include "study/run.hpp"
#include "world/world.hpp"

namespace meander {

/// Bytes that these keep alive, roughly: found by argument lookup when they are handed to Lua.
std::size_t native_size(const World& world);
std::size_t native_size(const Sim& sim);
std::size_t native_size(const Run& run);
std::size_t native_size(const Observation& observation);

}  // namespace meander

namespace meander::script {

/// A thing in a world, as scripts hold it.
struct Thing {
  std::shared_ptr<World> world;
  Id id;
};

/// One of the robots of a simulation: the truth about it.
struct RobotView {
  std::shared_ptr<Sim> sim;
  std::size_t index = 0;
};

/// A run with the world it went through, for its picture.
struct RunRecord {
  Run run;
  std::shared_ptr<const World> world;
};
inline std::size_t native_size(const RunRecord& record) {
  return meander::native_size(record.run) + meander::native_size(*record.world);
}

template <>
struct ObjectName<World> {
  static constexpr const char* value = "world";
};
template <>
struct ObjectName<Thing> {
  static constexpr const char* value = "thing";
};
template <>
struct ObjectName<Sim> {
  static constexpr const char* value = "sim";
};
template <>
struct ObjectName<RobotView> {
  static constexpr const char* value = "robot";
};
template <>
struct ObjectName<RunRecord> {
  static constexpr const char* value = "run";
};
template <>
struct ObjectName<Observation> {
  static constexpr const char* value = "observation";
};
template <>
struct ObjectName<Navigator> {
  static constexpr const char* value = "navigator";
};
template <>
struct ObjectName<Guide> {
  static constexpr const char* value = "guide";
};

}  // namespace meander::script
