// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Motion intervals of polar profiles and the way along corridors by them, in labyrinths that sonars without noise see.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/angle.hpp"
#include "grid/labyrinth.hpp"
#include "indicator/profile_way.hpp"

namespace meander {
namespace {

constexpr double kStep = 0.02;  ///< of rays and of the robot [m]

Platform small_robot() {
  Platform robot = platform("nomad200");
  robot.body.radius = 0.2;
  robot.sonar.radius = 0.17;
  return robot;
}

/// Corridors of 1 m between thin walls; cell (0, 0) has its middle at (0.5, 0.5).
class Corridors {
 public:
  explicit Corridors(Labyrinth labyrinth) : labyrinth_(std::move(labyrinth)) {}

  double way_to_wall(const Vec2& from, const Vec2& axis) const {
    for (double r = 0; r < 6.5; r += kStep)
      if (!passes(from + r * axis, from + (r + kStep) * axis)) return r;
    return 6.5;
  }
  /// The nearest wall in each cone of 25 degrees.
  Observation seen(const Platform& robot, const Pose2& pose) const {
    Observation all;
    all.odometry.pose = pose;
    for (int i = 0; i < robot.sonar.count; ++i) {
      const double bearing = wrap_angle(pose.heading + 2 * kPi * i / robot.sonar.count);
      const Vec2 from = pose.position() + robot.sonar.radius * Pose2{0, 0, bearing}.direction();
      double reading = 6.5;
      for (int ray = -5; ray <= 5; ++ray)
        reading =
            std::min(reading, way_to_wall(from, Pose2{0, 0, wrap_angle(bearing + radians(2.5) * ray)}.direction()));
      all.readings.sonar.push_back(reading);
      all.readings.sonar_pose.push_back(pose);
    }
    return all;
  }

 private:
  static Cell cell(const Vec2& at) {
    return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  }
  bool passes(const Vec2& from, const Vec2& to) const {
    const Cell a = cell(from), b = cell(to);
    if (a == b) return true;
    for (int side = 0; side < kSides; ++side)
      if (beside(a, side) == b) return labyrinth_.contains(a) && labyrinth_.open(a, side);
    return false;  // through a corner
  }
  Labyrinth labyrinth_;
};

/// A robot that moves to where it is told, a little at a time, and hears on the way.
class Walker {
 public:
  Walker(const Labyrinth& labyrinth, const Vec2& at)
      : corridors_(labyrinth), robot_(small_robot()), way_(robot_), at_(at) {
    hear();
  }
  /// Along the way until there is something to decide; at most so many metres.
  ProfileWay::Found go(double direction, double most) {
    way_.leave(direction);
    for (int i = 0; i < 5000 && way_.walked() < most; ++i) {
      const ProfileWay::Found found = way_.follow();
      if (found != ProfileWay::Found::way) return found;
      const Vec2 to = way_.aim() - at_;
      if (to.norm() > kStep) at_ += 2 * kStep / to.norm() * to;
      hear();
    }
    return ProfileWay::Found::way;
  }
  const Vec2& at() const { return at_; }
  ProfileWay& way() { return way_; }

 private:
  void hear() { way_.hear(corridors_.seen(robot_, {at_.x(), at_.y(), 0})); }
  Corridors corridors_;
  Platform robot_;
  ProfileWay way_;
  Vec2 at_;
};

Labyrinth with_open(int columns, int rows, const std::vector<std::pair<Cell, int>>& walls) {
  Labyrinth labyrinth(columns, rows);
  for (const auto& [cell, side] : walls) labyrinth.set_open(cell, side, true);
  return labyrinth;
}

bool leads(const std::vector<SeenPort>& ports, double direction) {
  return std::any_of(ports.begin(), ports.end(),
                     [&](const SeenPort& port) { return std::abs(angle_between(port.direction, direction)) < 0.45; });
}

TEST(SonarProfile, TheMotionIntervalsOfACellAreItsOpenSides) {
  const Platform robot = small_robot();
  for (int sides = 0; sides < 16; ++sides) {
    Labyrinth labyrinth(7, 7);
    for (int side = 0; side < kSides; ++side) {
      if ((sides >> side & 1) == 0) continue;
      for (Cell cell{3, 3}; labyrinth.contains(beside(cell, side)); cell = beside(cell, side))
        labyrinth.set_open(cell, side, true);
    }
    const Corridors corridors(labyrinth);
    for (const double heading : {0.0, 0.1, 0.4, 2.0}) {
      SonarProfile profile(robot);
      for (double off = -0.15; off < 0.16; off += 0.05)
        profile.update(corridors.seen(robot, {3.5 + off, 3.5 + off / 2, heading}));
      const std::vector<SeenPort> ports = profile.openings({3.5, 3.5});
      EXPECT_EQ(ports.size(), static_cast<std::size_t>(labyrinth.ways({3, 3}))) << sides << " " << heading;
      for (int side = 0; side < kSides; ++side)
        EXPECT_EQ(leads(ports, wrap_angle(side * kPi / 2)), labyrinth.open({3, 3}, side)) << sides << " " << heading;
    }
  }
}

TEST(SonarProfile, WhatALaterBeamGoesThroughIsForgottenAndSoIsWhatWasHeardLongAgo) {
  const Platform robot = small_robot();
  const Corridors closed(Labyrinth(1, 1)), open(with_open(2, 1, {{{0, 0}, 0}}));
  SonarProfile profile(robot);
  for (int i = 0; i < 3; ++i) profile.update(closed.seen(robot, {0.5, 0.5, 0}));
  EXPECT_LT(profile.way_on({0.5, 0.5}, 0), 0.5);
  for (int i = 0; i < 3; ++i) profile.update(open.seen(robot, {0.5, 0.5, 0}));
  EXPECT_GT(profile.way_on({0.5, 0.5}, 0), 1.0);
  Observation silent = open.seen(robot, {0.5, 0.5, 0});
  std::fill(silent.readings.sonar.begin(), silent.readings.sonar.end(), 0.0);
  for (int i = 1; i <= 30; ++i) {
    silent.odometry.pose.x += 0.1;
    for (Pose2& pose : silent.readings.sonar_pose) pose = silent.odometry.pose;
    profile.update(silent);
  }
  EXPECT_GT(profile.way_on({0.5, 0.5}, kPi), 2.0);  // the wall behind was heard more than 2 m ago
}

TEST(ProfileWay, ACorridorIsFollowedRoundItsCornersToItsEnd) {
  Walker robot(with_open(3, 3, {{{0, 0}, 0}, {{1, 0}, 0}, {{2, 0}, 1}, {{2, 1}, 1}, {{2, 2}, 2}}), {0.5, 0.5});
  EXPECT_EQ(robot.go(0, 20), ProfileWay::Found::dead_end);
  EXPECT_LT((robot.at() - Vec2(1.5, 2.5)).norm(), 0.4);
  EXPECT_EQ(robot.way().openings().size(), 1u);
  EXPECT_TRUE(leads(robot.way().openings(), 0));
}

TEST(ProfileWay, ACrossingIsFoundAndItsPortsAreReadAtItsMiddle) {
  const Labyrinth labyrinth =
      with_open(7, 7, {{{0, 3}, 0}, {{1, 3}, 0}, {{2, 3}, 0}, {{3, 3}, 1}, {{3, 4}, 1}, {{3, 3}, 3}, {{3, 2}, 3}});
  Walker robot(labyrinth, {0.5, 3.5});
  ASSERT_EQ(robot.go(0, 20), ProfileWay::Found::crossing);
  EXPECT_LT((robot.at() - Vec2(3.5, 3.5)).norm(), 0.3);
  const std::vector<SeenPort> ports = robot.way().openings();
  EXPECT_EQ(ports.size(), 3u);
  for (const double direction : {kPi / 2, -kPi / 2, kPi}) EXPECT_TRUE(leads(ports, direction)) << direction;
  EXPECT_TRUE(robot.way().back());
  EXPECT_LT(std::abs(angle_between(*robot.way().back(), kPi)), 0.3);
}

TEST(ProfileWay, WhereItHearsTheSameWithoutEndItDoesNotGoRoundForEver) {
  std::vector<std::pair<Cell, int>> ring;
  for (int i = 0; i < 3; ++i) ring.insert(ring.end(), {{{i, 0}, 0}, {{i, 3}, 0}, {{0, i}, 1}, {{3, i}, 1}});
  Walker robot(with_open(4, 4, ring), {1.5, 0.5});
  EXPECT_EQ(robot.go(0, 30), ProfileWay::Found::crossing);
  EXPECT_LT((robot.at() - Vec2(1.5, 0.5)).norm(), 0.6);
}

TEST(SonarProfile, DirectionsWiderThanTheWidestIntervalAreRefused) {
  for (const int directions : {8, 36})
    EXPECT_THROW(SonarProfile(small_robot(), {.directions = directions, .most = 0.1}), ArgumentError) << directions;
  EXPECT_NO_THROW(SonarProfile(small_robot(), {.directions = 8, .most = 0.79}));
}

}  // namespace
}  // namespace meander
