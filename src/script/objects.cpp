// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/objects.hpp"

namespace meander {
namespace {

std::size_t point_count(const Shape& shape) {
  std::size_t count = 0;
  for (const Ring& ring : rings(shape)) count += ring.points.size();
  return count;
}

std::size_t item_size(const Item& item) {
  const Shape* shape = blocking_shape(item);
  return sizeof(Item) + (shape ? point_count(*shape) * sizeof(Vec2) : 0);
}

}  // namespace

std::size_t native_size(const World& world) {
  // Things stand in their slot, in the log and in the undo history.
  std::size_t items = 0;
  for (const Id id : world.ids()) items += item_size(world.item(id));
  return sizeof(World) + 3 * items + world.log().size() * sizeof(Edit);
}

std::size_t native_size(const Sim& sim) {
  // The ray-cast index repeats the walls of the world.
  return sizeof(Sim) + 2 * native_size(sim.world());
}

std::size_t native_size(const Run& run) {
  const std::size_t sonars = run.steps.empty() ? 0 : run.steps.front().sonar.size();
  return sizeof(Run) + run.steps.size() * (sizeof(RunStep) + sonars * sizeof(float));
}

std::size_t native_size(const Observation& observation) {
  const Readings& readings = observation.readings;
  return sizeof(Observation) + readings.sonar.size() * (sizeof(double) + sizeof(Pose2)) + readings.bumper.size();
}

}  // namespace meander
