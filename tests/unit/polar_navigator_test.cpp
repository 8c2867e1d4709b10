// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_navigator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "polar_support.hpp"
#include "robot/kinematics.hpp"

namespace meander {

std::size_t allocations();  // allocation_counter.cpp

namespace {

constexpr double kNothing = 6.477;

Observation seeing(const Pose2& pose, double everywhere, double time = 0, double v = 0) {
  Observation observation;
  observation.time = time;
  observation.period = 0.33;
  observation.odometry = {pose, v, 0};
  observation.readings.sonar.assign(16, everywhere);
  observation.readings.sonar_pose.assign(16, pose);
  return observation;
}

Subgoal at(double x, double y, double tolerance = 0.25) {
  return {.position = {x, y}, .tolerance = tolerance, .heading = {}, .name = {}};
}

Navigator polar(const PolarOptions& options = {}) { return polar_navigator(platform("nomad200"), options); }

PolarOptions with(const PolarLayoutOptions& layout, int passes = 2) {
  PolarOptions options;
  options.map.layout = layout;
  options.solver.passes = passes;
  return options;
}

TEST(PolarNavigator, DrivesStraightToASubgoalInTheOpen) {
  const NavigatorStep step = polar().step(seeing({}, kNothing), at(5, 0));
  EXPECT_EQ(step.status, NavigatorStatus::driving);
  EXPECT_NEAR(step.command.v, 0.762 * 0.33, 1e-9) << "all that can be reached in a period";
  EXPECT_NEAR(step.command.w, 0, 1e-9);
}

TEST(PolarNavigator, TurnsToATargetBehind) {
  const NavigatorStep step = polar().step(seeing({}, kNothing), at(-3, 0));
  EXPECT_GT(std::abs(step.command.w), 0.3);
}

TEST(PolarNavigator, ArrivesOnTheTarget) {
  for (const Subgoal& subgoal : {at(0, 0), at(0.2, 0), at(0.1, -0.1)})
    EXPECT_EQ(polar().step(seeing({}, kNothing), subgoal).status, NavigatorStatus::arrived);
  // Inside the body, but not within the tolerance.
  const NavigatorStep near = polar().step(seeing({}, kNothing), at(0.1, 0, 0.0254));
  EXPECT_EQ(near.status, NavigatorStatus::driving);
  EXPECT_GT(near.command.v, 0);
}

TEST(PolarNavigator, TurnsToTheHeadingWanted) {
  Subgoal subgoal = at(0.1, 0);
  subgoal.heading = 1.5;
  const NavigatorStep turning = polar().step(seeing({}, kNothing), subgoal);
  EXPECT_EQ(turning.status, NavigatorStatus::driving);
  EXPECT_EQ(turning.command.v, 0);
  EXPECT_GT(turning.command.w, 0);
  EXPECT_EQ(polar().step(seeing({0, 0, 1.5}, kNothing), subgoal).status, NavigatorStatus::arrived);
}

TEST(PolarNavigator, StandsAndLooksAroundWhenEnclosed) {
  Navigator navigator = polar();
  const NavigatorStep step = navigator.step(seeing({}, 0.3), at(3, 0));
  EXPECT_EQ(step.command.v, 0);
  EXPECT_EQ(std::abs(step.command.w), 0.4);
  EXPECT_FALSE(polar_inside(navigator)->subgoal().has_value());
}

TEST(PolarNavigator, AllReadingsAtTheMinimumMeanContactAllAround) {
  const NavigatorStep step = polar().step(seeing({}, 0.152), at(3, 0));
  EXPECT_EQ(step.command.v, 0);
}

TEST(PolarNavigator, DrivesWithoutAnyReadings) {
  Observation observation = seeing({}, kNothing);
  observation.readings.sonar.clear();
  observation.readings.sonar_pose.clear();
  EXPECT_GT(polar().step(observation, at(3, 0)).command.v, 0);
}

/// In contact ahead it does not push; away from the wall it may drive.
TEST(PolarNavigator, GetsAwayFromAWallThatItTouches) {
  Observation observation = seeing({}, kNothing);
  observation.readings.sonar[0] = observation.readings.sonar[1] = observation.readings.sonar[15] = 0.152;
  const NavigatorStep ahead = polar().step(observation, at(3, 0));
  EXPECT_LT(ahead.command.v, 0.02);
  const NavigatorStep behind = polar().step(observation, at(-3, 0));
  EXPECT_GT(std::abs(behind.command.w), 0.1);
}

TEST(PolarNavigator, TurnedSituationsAreAnsweredAlike) {
  const double sector = 2 * kPi / 48;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const int sectors : {1, 7, 24}) {
      Navigator here = polar(), turned = polar();
      const Pose2 frame{1, 2, sector * sectors};
      Stream random(seed, "readings");
      for (int cycle = 0; cycle < 5; ++cycle) {
        const Pose2 pose{0.05 * cycle, 0.01 * cycle, 0.03 * cycle};
        Observation observation = seeing(pose, kNothing, 0.33 * cycle, 0.15);
        for (double& range : observation.readings.sonar) range = random.uniform(0.4, 3.5);
        Observation other = observation;
        other.odometry.pose = frame * pose;
        for (Pose2& p : other.readings.sonar_pose) p = frame * p;
        const Vec2 target(4, 1), moved = frame * target;
        const NavigatorStep a = here.step(observation, at(4, 1)), b = turned.step(other, at(moved.x(), moved.y()));
        EXPECT_NEAR(a.command.v, b.command.v, 1e-9) << seed;
        EXPECT_NEAR(a.command.w, b.command.w, 1e-9) << seed;
      }
    }
  }
}

TEST(PolarNavigator, SaysThatItIsTrappedAfterItsEscapes) {
  PolarOptions options;
  options.trap.escapes = 2;
  Navigator navigator = polar(options);
  int escapes = 0;
  double time = 0;
  for (; time < 200; time += 0.33) {
    const NavigatorStep step = navigator.step(seeing({}, kNothing, time), at(3, 0));
    escapes += step.reason.find("escape") != std::string::npos && step.status == NavigatorStatus::driving;
    if (step.status != NavigatorStatus::trapped) continue;
    EXPECT_EQ(step.reason, "no way on for 15 s, 3.00 m from the subgoal, after 2 escapes");
    EXPECT_EQ(step.command, Command{});
    break;
  }
  EXPECT_EQ(escapes, 2);
  EXPECT_NEAR(time, 3 * 15, 2);
  EXPECT_EQ(polar_inside(navigator)->trap().traps(), 1);
}

TEST(PolarNavigator, PaperModeTurnsTheRemediesOff) {
  PolarOptions options;
  options.mode = PolarMode::paper;
  const PolarNavigator navigator(platform("nomad200"), options);
  EXPECT_EQ(navigator.options().memory.contradictions, 0);
  EXPECT_EQ(navigator.options().subgoal.hysteresis, 0);
  EXPECT_FALSE(navigator.options().trap.watch);
  EXPECT_EQ(navigator.options().control.soft_speed_cost, 0);
}

TEST(PolarNavigator, PartsCanBeReplaced) {
  PolarParts parts;
  parts.objective = [](const MotionCandidate& c) { return std::abs(c.command.v - 0.1) + std::abs(c.command.w + 0.1); };
  int asked = 0;
  parts.subgoal = [&](const PolarState& state) -> std::optional<PolarSubgoal> {
    ++asked;
    return PolarSubgoal{.sector = 3, .ring = 50, .position = state.layout.position(50, 3)};
  };
  parts.weights = [](const PolarLayout& layout, int ring) {
    return ring_weights(layout, PolarWeights::finite_volume, 20)[static_cast<std::size_t>(ring)];
  };
  Navigator navigator = polar_navigator(platform("nomad200"), with({.rings = 60, .sectors = 24}), parts);
  const NavigatorStep step = navigator.step(seeing({}, kNothing), at(3, 0));
  EXPECT_NEAR(step.command.v, 0.1, 0.03);
  EXPECT_NEAR(step.command.w, -0.1, 0.03);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(polar_inside(navigator)->subgoal()->sector, 3);
}

TEST(PolarNavigator, AllocatesNothingPerCycle) {
  Navigator navigator = polar();
  Stream random(1, "readings");
  std::size_t before = 0;
  Observation observation = seeing({}, kNothing);
  const Subgoal subgoal = at(4, 1);
  for (int cycle = 0; cycle < 60; ++cycle) {
    observation.time += 0.33;
    observation.odometry.pose.x += 0.05;
    std::fill(observation.readings.sonar_pose.begin(), observation.readings.sonar_pose.end(),
              observation.odometry.pose);
    for (double& range : observation.readings.sonar) range = random.uniform(0.3, 3.5);
    if (cycle == 20) before = allocations();
    navigator.step(observation, subgoal);
  }
  EXPECT_EQ(allocations(), before);
}

TEST(PolarNavigator, UnusableOptionsAreErrors) {
  EXPECT_THROW(polar(with({.rings = 2})), ArgumentError);
  EXPECT_THROW(polar(with({.scope = 0.04, .radii = PolarRadii::log})), ArgumentError);
  EXPECT_THROW(polar(with({}, 0)), ArgumentError);
}

TEST(Predictor, FindsOutTheLatencyByTheOdometry) {
  for (int latency = 0; latency <= 2; ++latency) {
    Predictor predictor(platform("nomad200"), {});
    const Body& body = platform("nomad200").body;
    Stream random(7, "commands");
    std::vector<Command> sent;
    Observation observation = seeing({}, kNothing);
    for (int k = 0; k < 20; ++k) {
      predictor.predict(observation);
      sent.push_back({random.uniform(0, 0.6), random.uniform(-0.7, 0.7), 0});
      predictor.commanded(sent.back());
      const int active = k - latency;
      const Command command = active >= 0 ? sent[static_cast<std::size_t>(active)] : Command{};
      observation.odometry.v = ramp(observation.odometry.v, command.v, body.a_v * 0.33);
      observation.odometry.w = ramp(observation.odometry.w, command.w, body.a_w * 0.33);
    }
    EXPECT_EQ(predictor.latency(), latency);
  }
}

TEST(SonarMemory, ForgetsOldScansAndContradictedPoints) {
  const Platform& nomad = platform("nomad200");
  SonarMemory memory(nomad, {.scans = 3});
  Observation wall = seeing({}, kNothing), open = seeing({}, kNothing);
  wall.readings.sonar[0] = 1.0;
  memory.remember(wall.readings);
  ASSERT_EQ(memory.scan(0).size(), 1u);
  EXPECT_NEAR(memory.scan(0)[0].position.x(), 1.23, 1e-12);
  memory.remember(open.readings);
  EXPECT_EQ(memory.scan(1).size(), 1u) << "contradicted once";
  memory.remember(open.readings);
  EXPECT_EQ(memory.scan(2).size(), 0u) << "twice";
  SonarMemory trusting(nomad, {.scans = 3, .contradictions = 0});
  trusting.remember(wall.readings);
  trusting.remember(open.readings);
  trusting.remember(open.readings);
  EXPECT_EQ(trusting.scan(2).size(), 1u);
  trusting.remember(open.readings);
  EXPECT_EQ(trusting.scans(), 3);
  for (int age = 0; age < 3; ++age) EXPECT_EQ(trusting.scan(age).size(), 0u) << "the oldest made room";
}

}  // namespace
}  // namespace meander
