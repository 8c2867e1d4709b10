// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/potential_field.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "polar/echo.hpp"

namespace meander {
namespace {

constexpr double kNothing = 6.477;

/// What the robot at this pose sees when the given transducers echo and the rest do not.
Observation seeing(const Pose2& pose, const std::vector<std::pair<std::size_t, double>>& echoes, double v = 0) {
  Observation observation;
  observation.period = 0.33;
  observation.odometry = {pose, v, 0};
  observation.readings.sonar.assign(16, kNothing);
  observation.readings.sonar_pose.assign(16, pose);
  for (const auto& [i, range] : echoes) observation.readings.sonar[i] = range;
  return observation;
}

Subgoal ahead(double distance) { return {.position = {distance, 0}, .tolerance = 0.25, .heading = {}, .name = {}}; }

Navigator field(const PotentialFieldOptions& options = {}) { return potential_field(platform("nomad200"), options); }

TEST(PotentialFieldTest, DrivesStraightToASubgoalInTheOpen) {
  const NavigatorStep step = field().step(seeing({}, {}), ahead(5));
  EXPECT_EQ(step.status, NavigatorStatus::driving);
  EXPECT_NEAR(step.command.v, platform("nomad200").body.v_max, 1e-12);
  EXPECT_NEAR(step.command.w, 0, 1e-12);
}

/// A platform that needs 5000 km to stop: the look ahead is bounded, and sees the wall before it all the same.
TEST(PotentialFieldTest, LooksAheadOnlySoFarWhereBrakingIsWeak) {
  Platform weak = platform("nomad200");
  weak.body.v_max = 100;
  weak.body.a_v = 1e-3;
  Observation open = seeing({}, {{8, 1.0}}, 100), closed = seeing({}, {{0, 1.5}}, 100);
  open.period = closed.period = 0.001;
  Navigator navigator = potential_field(weak);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 10; ++i) {
    EXPECT_GT(navigator.step(open, ahead(1e9)).command.v, 1);
    EXPECT_EQ(navigator.step(closed, ahead(1e9)).command.v, 0);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(PotentialFieldTest, TurnsTowardsTheSubgoalOnEitherSideAlike) {
  const Subgoal left{.position = {0, 3}, .tolerance = 0.25, .heading = {}, .name = {}};
  const Subgoal right{.position = {0, -3}, .tolerance = 0.25, .heading = {}, .name = {}};
  const Command a = field().step(seeing({}, {}), left).command, b = field().step(seeing({}, {}), right).command;
  EXPECT_GT(a.w, 0.1);
  EXPECT_NEAR(a.w, -b.w, 1e-12);
  EXPECT_NEAR(a.v, b.v, 1e-12);
  EXPECT_NEAR(a.v, 0, 1e-9) << "nothing is gained by driving across";
}

TEST(PotentialFieldTest, CommandsDoNotDependOnWhereTheFrameLies) {
  const Pose2 moved{3, -2, 0.7};
  const Subgoal goal = ahead(5);
  const Subgoal moved_goal{.position = moved * goal.position, .tolerance = 0.25, .heading = {}, .name = {}};
  const std::vector<std::pair<std::size_t, double>> echoes{{1, 0.5}, {2, 0.6}};
  const Command here = field().step(seeing({}, echoes), goal).command;
  const Command there = field().step(seeing(moved, echoes), moved_goal).command;
  EXPECT_NEAR(here.v, there.v, 1e-9);
  EXPECT_NEAR(here.w, there.w, 1e-9);
}

TEST(PotentialFieldTest, IsPushedAwayFromASurfaceAtItsSide) {
  EXPECT_LT(field().step(seeing({}, {{3, 0.16}, {4, 0.16}, {5, 0.16}}), ahead(5)).command.w, -0.05);
  EXPECT_GT(field().step(seeing({}, {{11, 0.16}, {12, 0.16}, {13, 0.16}}), ahead(5)).command.w, 0.05);
}

TEST(PotentialFieldTest, BrakesForAWallAheadInTime) {
  const Body body = platform("nomad200").body;
  for (double range = 0.2; range < 2; range += 0.02) {
    const double v =
        field().step(seeing({}, {{15, range * 1.02}, {0, range}, {1, range * 1.02}}, body.v_max), ahead(5)).command.v;
    const double way = 0.33 * v + v * v / (2 * body.a_v);
    const double free = range + platform("nomad200").sonar.radius - body.radius;
    // At full speed, what cannot be avoided any more may not be made worse.
    if (v > 0) {
      EXPECT_LE(way, free) << range;
    }
  }
  EXPECT_EQ(field().step(seeing({}, {{0, 0.152}}), ahead(5)).command.v, 0);
}

TEST(PotentialFieldTest, ArrivesAndThenTurnsToTheHeadingAskedFor) {
  Subgoal goal = ahead(0.2);
  const NavigatorStep there = field().step(seeing({}, {}), goal);
  EXPECT_EQ(there.status, NavigatorStatus::arrived);
  EXPECT_EQ(there.command, Command{});
  goal.heading = 1.5;
  const NavigatorStep turning = field().step(seeing({}, {}), goal);
  EXPECT_EQ(turning.status, NavigatorStatus::driving);
  EXPECT_EQ(turning.command.v, 0);
  EXPECT_GT(turning.command.w, 0);
  EXPECT_EQ(field().step(seeing({0, 0, 1.49}, {}), goal).status, NavigatorStatus::arrived);
}

TEST(PotentialFieldTest, SaysThatItIsTrappedAfterItsPatience) {
  const Navigator navigator = field({.patience = 5});
  Observation observation = seeing({}, {{0, 0.152}});
  for (observation.time = 0; observation.time <= 5; observation.time += 0.33)
    ASSERT_EQ(navigator.step(observation, ahead(3)).status, NavigatorStatus::driving);
  const NavigatorStep trapped = navigator.step(observation, ahead(3));
  EXPECT_EQ(trapped.status, NavigatorStatus::trapped);
  EXPECT_EQ(trapped.reason, "no progress for 5 s, 3.00 m from the subgoal: pull and push balance");
  EXPECT_EQ(trapped.command, Command{});
  EXPECT_EQ(navigator.step(observation, ahead(4)).status, NavigatorStatus::driving) << "a new subgoal, a new chance";
  navigator.step(observation, ahead(3));
  navigator.reset();
  EXPECT_EQ(navigator.step(observation, ahead(3)).status, NavigatorStatus::driving);
}

TEST(PotentialFieldTest, OptionsAreChecked) {
  EXPECT_THROW(field({.influence = -1}), ArgumentError);
  EXPECT_THROW(field({.patience = std::nan("")}), ArgumentError);
}

std::vector<Echo> echoes_of(const Observation& observation) {
  std::vector<Echo> echoes;
  read_echoes(observation, platform("nomad200"), {}, echoes);
  return echoes;
}

/// Ranges of a long straight wall: the nearest point within each cone.
TEST(Echoes, OfAWallLieOnTheWall) {
  const double half = EchoRule{}.half_cone, ring = platform("nomad200").sonar.radius;
  for (double normal = -0.19; normal <= 0.19; normal += 0.01)
    for (double distance = 0.45; distance < 1.5; distance += 0.1) {
      std::vector<std::pair<std::size_t, double>> seen;
      for (const int i : {-1, 0, 1}) {
        const double bearing = i * kPi / 8, off = std::abs(bearing - normal);
        const double free = distance - ring * std::cos(off);
        seen.emplace_back(static_cast<std::size_t>((i + 16) % 16), free / std::cos(std::max(0.0, off - half)));
      }
      for (const Echo& echo : echoes_of(seeing({}, seen))) {
        const double found = echo.point.x() * std::cos(normal) + echo.point.y() * std::sin(normal);
        EXPECT_NEAR(found, distance, 0.03 * distance) << normal;
      }
    }
}

TEST(Echoes, AreWhereTheRobotWasWhenTheyCame) {
  Observation observation = seeing({1, 0, 0}, {{0, 1}});
  observation.readings.sonar_pose[0] = {0.5, 0, 0};
  const auto echoes = echoes_of(observation);
  ASSERT_EQ(echoes.size(), 1u);
  EXPECT_NEAR(echoes[0].axis.x(), 0.5 + 0.23 + 1 - 1, 1e-12);
  EXPECT_TRUE(echoes[0].nearest);
}

TEST(Echoes, OfTheLeastRangeMayTouchTheHull) {
  const auto echoes = echoes_of(seeing({}, {{4, 0.152}}));
  ASSERT_EQ(echoes.size(), 1u);
  EXPECT_LT(echoes[0].gap, 0.05);
}

}  // namespace
}  // namespace meander
