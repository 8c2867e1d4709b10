// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>
#include <vector>

#include "base/random.hpp"
#include "sim/sim.hpp"

namespace meander {

/// A closed room of the given size with its lower left corner at the origin, without a start.
inline std::shared_ptr<World> room(double width, double height) {
  Header header;
  header.title = "room";
  header.bounds = {{0, 0}, {width, height}};
  auto world = std::make_shared<World>(header);
  world->add(Obstacle{
      .name = "walls", .shape = Chain{{{0, 0}, {width, 0}, {width, height}, {0, height}}, true}, .surface = {}});
  return world;
}

/// A room of 8 x 8 m with boxes, poles and thin walls scattered in it; the start in the middle is free.
inline std::shared_ptr<World> cluttered(std::uint64_t seed) {
  auto world = room(8, 8);
  Header header = world->header();
  header.start = Pose2{4, 4, 0};
  world->set_header(header);
  Stream random(seed, "clutter");
  for (int i = 0; i < 14; ++i) {
    const Vec2 at{random.uniform(0.5, 7.5), random.uniform(0.5, 7.5)};
    if ((at - Vec2{4, 4}).norm() < 1.2) continue;
    Shape shape;
    if (i % 3 == 0)
      shape = Rectangle{at, {random.uniform(0.1, 0.8), random.uniform(0.1, 0.8)}, random.uniform(-3, 3)};
    else if (i % 3 == 1)
      shape = Disc{at, random.uniform(0.02, 0.4)};
    else
      shape = Chain{{at, at + Vec2{random.uniform(0.1, 0.6), random.uniform(-0.6, 0.6)}}, false};
    world->add(Obstacle{.name = "", .shape = shape, .surface = {}});
  }
  return world;
}

inline RobotOptions nomad(std::optional<Pose2> start = {}) {
  RobotOptions robot;
  robot.platform = platform("nomad200");
  robot.start = start;
  return robot;
}

/// Commands that change every second or so, the same for the same seed.
class Wanderer {
 public:
  explicit Wanderer(std::uint64_t seed) : random_(seed, "wanderer") {}
  Command next() {
    if (random_.chance(0.3)) command_ = {random_.uniform(-0.1, 0.7), random_.uniform(-0.8, 0.8), 0};
    return command_;
  }

 private:
  Stream random_;
  Command command_{0.5, 0, 0};
};

/// Distance from the robot's hull to the nearest obstacle, by asking every item of the world.
inline double true_clearance(const Sim& sim, std::size_t robot = 0) {
  const Vec2 at = sim.state(robot).pose_world.position();
  double gap = kClearanceSeen;
  for (const Id id : sim.world().ids())
    if (const Shape* shape = blocking_shape(sim.world().item(id))) gap = std::min(gap, distance(*shape, at));
  return gap - sim.robot(robot).platform.body.radius;
}

}  // namespace meander
