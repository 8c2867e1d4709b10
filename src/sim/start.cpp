// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sim/start.hpp"

#include <cmath>

namespace meander {
namespace {

/// Says which robot only where there are several, counted from 1 as in scripts.
std::string label(std::size_t robot, std::size_t count) {
  return count > 1 ? fmt::format("robot {}: ", robot + 1) : std::string();
}

std::string spot(const Vec2& p) { return fmt::format("({:.2f}, {:.2f})", p.x(), p.y()); }

Pose2 start_of(const World& world, const RobotOptions& robot, const std::string& who) {
  const auto start = robot.start ? robot.start : world.header().start;
  if (!start) fail("{}no start: the world has none, so the robot needs start = {{x, y, heading}}", who);
  if (!std::isfinite(start->x) || !std::isfinite(start->y) || !std::isfinite(start->heading))
    fail("{}start: finite x, y and heading expected, got ({}, {}, {})", who, start->x, start->y, start->heading);
  const Box& bounds = world.header().bounds;
  if (!bounds.contains(start->position()))
    fail("{}start {} is outside the world's bounds {} to {}", who, spot(start->position()), spot(bounds.low),
         spot(bounds.high));
  return *start;
}

/// Distance from a point to what stands in the way; nothing for things that do not.
std::optional<double> distance_to(const Item& item, const Vec2& p) {
  if (const auto* mover = std::get_if<Mover>(&item)) return distance(Shape{mover->disc}, p);
  const Shape* shape = blocking_shape(item);
  return shape ? std::optional(distance(*shape, p)) : std::nullopt;
}

void check_free(const World& world, const Pose2& start, double radius, const std::string& who) {
  for (const Id id : world.ids()) {
    const Item& item = world.item(id);
    const auto gap = distance_to(item, start.position());
    if (!gap || *gap >= radius) continue;
    if (*gap == 0)
      fail("{}start {} is inside {} '{}'; free space of the robot's radius {:.3g} m expected", who,
           spot(start.position()), kind_of(item), name_of(item), radius);
    fail("{}start {} is {:.3f} m from {} '{}'; at least the robot's radius {:.3g} m expected", who,
         spot(start.position()), *gap, kind_of(item), name_of(item), radius);
  }
}

}  // namespace

std::vector<Pose2> checked_starts(const World& world, const std::vector<RobotOptions>& robots) {
  std::vector<Pose2> starts;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const std::string who = label(k, robots.size());
    validate(robots[k].platform, who + "platform.");
    validate(robots[k].sonar, who + "sonar.");
    validate(robots[k].drift, who + "drift.");
    validate(robots[k].whisker, who + "whisker.");
    validate(robots[k].light, who + "light.");
    const double radius = robots[k].platform.body.radius;
    starts.push_back(start_of(world, robots[k], who));
    check_free(world, starts[k], radius, who);
    for (std::size_t other = 0; other < k; ++other) {
      const double apart = (starts[other].position() - starts[k].position()).norm();
      const double least = radius + robots[other].platform.body.radius;
      if (apart < least)
        fail("{}start {} overlaps robot {} at {}: {:.3f} m apart, at least {:.3f} m expected", who,
             spot(starts[k].position()), other + 1, spot(starts[other].position()), apart, least);
    }
  }
  return starts;
}

}  // namespace meander
