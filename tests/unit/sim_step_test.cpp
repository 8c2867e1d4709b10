// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "sim_worlds.hpp"

namespace meander {
namespace {

TEST(Step, NeverPenetratesAndCountsWhatItTouches) {
  int contacts = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Sim sim(cluttered(seed), {nomad()}, {.seed = seed});
    Wanderer wanderer(seed);
    for (int i = 0; i < 300; ++i) {
      sim.step(wanderer.next());
      const double clearance = true_clearance(sim);
      ASSERT_GE(clearance, 0) << "seed " << seed << " step " << i;
      ASSERT_NEAR(sim.state().clearance, clearance, 1e-9);
      ASSERT_EQ(sim.state().touching, clearance <= kContactGap);
    }
    contacts += sim.state().contacts;
    EXPECT_EQ(sim.state().contacts, sim.state().fault_contacts) << "static obstacles never come to the robot";
  }
  EXPECT_GT(contacts, 40);
}

TEST(Step, StopsWithinAMicrometreOfTheWall) {
  Sim sim(room(10, 4), {nomad(Pose2{5, 2, 0})}, {});
  for (int i = 0; i < 40; ++i) sim.step({0.6, 0, 0});
  const double gap = 10 - sim.robot().platform.body.radius - sim.state().pose_world.x;
  EXPECT_GE(gap, 0);
  EXPECT_LE(gap, 1e-6);
  EXPECT_EQ(sim.state().v, 0);
  EXPECT_TRUE(sim.state().touching);
  EXPECT_EQ(sim.state().contacts, 1) << "one episode, however long it pushes";
  EXPECT_EQ(sim.state().fault_contacts, 1);
}

TEST(Step, TurnsAtTheWallAndDrivesAway) {
  Sim sim(room(10, 4), {nomad(Pose2{9, 2, 0})}, {});
  for (int i = 0; i < 12; ++i) sim.step({0.6, 0, 0});
  ASSERT_TRUE(sim.state().touching);
  const Vec2 at = sim.state().pose_world.position();
  while (std::abs(sim.state().pose_world.heading) < 2.5) sim.step({0, 0.7, 0});
  EXPECT_EQ(sim.state().pose_world.position(), at) << "turning on the spot moves nothing";
  for (int i = 0; i < 10; ++i) sim.step({0.6, 0, 0});
  EXPECT_GT((sim.state().pose_world.position() - at).norm(), 0.5);
  EXPECT_FALSE(sim.state().touching);
  EXPECT_EQ(sim.state().contacts, 1);
  for (int i = 0; i < 60; ++i) sim.step({0.6, 0, 0});
  EXPECT_EQ(sim.state().contacts, 2) << "a second wall is a second episode";
}

TEST(Step, DoesNotSlideAlongAWall) {
  Sim sim(room(10, 4), {nomad(Pose2{5, 2, 1.2})}, {});
  for (int i = 0; i < 30; ++i) sim.step({0.6, 0, 0});
  const Pose2 stuck = sim.state().pose_world;
  for (int i = 0; i < 10; ++i) sim.step({0.6, 0, 0});
  EXPECT_EQ(sim.state().pose_world, stuck);
}

TEST(Step, AccelerationAndSpeedKeepTheirLimits) {
  Sim sim(room(40, 40), {nomad(Pose2{20, 20, 0})}, {});
  const Body& body = sim.robot().platform.body;
  Wanderer wanderer(3);
  double v = 0, w = 0;
  for (int i = 0; i < 200; ++i) {
    Command command = wanderer.next();
    command.v *= 10;
    command.w *= 10;
    sim.step(command);
    const RobotState& s = sim.state();
    EXPECT_LE(std::abs(s.v - v), body.a_v * sim.period() + 1e-12);
    EXPECT_LE(std::abs(s.w - w), body.a_w * sim.period() + 1e-12);
    EXPECT_GE(s.v, body.v_min);
    EXPECT_LE(s.v, body.v_max);
    EXPECT_LE(std::abs(s.w), body.w_max);
    v = s.v;
    w = s.w;
  }
}

TEST(Step, TopSpeedComesAfterTheRampAndTheWayIsExact) {
  Sim sim(room(40, 4), {nomad(Pose2{2, 2, 0})}, {});
  const Body& body = sim.robot().platform.body;
  for (int i = 0; i < 30; ++i) sim.step({1, 0, 0});
  const double ramp_time = body.v_max / body.a_v;
  EXPECT_NEAR(sim.state().travelled, body.v_max * (30 * 0.33 - ramp_time / 2), 1e-9);
  EXPECT_NEAR(sim.state().pose_world.x, 2 + sim.state().travelled, 1e-9);
}

TEST(Step, CommandsTakeEffectAfterTheDelay) {
  for (const int delay : {0, 1, 3}) {
    Sim sim(room(20, 4), {nomad(Pose2{2, 2, 0})}, {.command_delay = delay});
    for (int i = 0; i < delay; ++i) {
      sim.step({0.5, 0, 0});
      EXPECT_EQ(sim.state().travelled, 0) << delay;
    }
    sim.step({0, 0, 0});
    EXPECT_GT(sim.state().travelled + (delay == 0), 0) << delay;
  }
}

TEST(Step, OdometryIsTheTruthWithoutDrift) {
  Sim sim(cluttered(5), {nomad()}, {.seed = 5});
  Wanderer wanderer(5);
  for (int i = 0; i < 300; ++i) {
    const Observation& seen = sim.step(wanderer.next());
    EXPECT_NEAR(seen.odometry.pose.x, sim.state().pose_world.x, 1e-6);
    EXPECT_NEAR(seen.odometry.pose.y, sim.state().pose_world.y, 1e-6);
    EXPECT_NEAR(angle_between(seen.odometry.pose.heading, sim.state().pose_world.heading), 0, 1e-9);
    EXPECT_EQ(seen.odometry.v, sim.state().v);
  }
}

TEST(Step, SonarsFireWhileTheRobotMoves) {
  RobotOptions robot = nomad(Pose2{2, 2, 0});
  robot.sonar.firing = Firing::sequence;
  Sim sim(room(20, 4), {robot}, {});
  for (int i = 0; i < 5; ++i) sim.step({0.6, 0, 0});
  const double before = sim.state().pose_world.x;
  const Readings& readings = sim.step({0.6, 0, 0}).readings;
  EXPECT_EQ(readings.sonar.size(), 16u);
  for (const Pose2& pose : readings.sonar_pose) {
    EXPECT_GT(pose.x, before);
    EXPECT_LE(pose.x, sim.state().pose_world.x + 1e-12);
  }
  robot.sonar.firing = Firing::simultaneous;
  Sim at_once(room(20, 4), {robot}, {});
  for (int i = 0; i < 5; ++i) at_once.step({0.6, 0.1, 0});
  for (const Pose2& pose : at_once.observation().readings.sonar_pose)
    EXPECT_EQ(pose, at_once.observation().odometry.pose);
}

TEST(Step, ASonarSeesTheWallWhereItStood) {
  RobotOptions robot = nomad(Pose2{2, 2, 0});
  robot.sonar = sonar_preset("ideal");
  robot.sonar.noise = robot.sonar.noise_proportional = 0;
  Sim sim(room(6, 4), {robot}, {});
  for (int i = 0; i < 8; ++i) {
    const Readings& readings = sim.step({0.5, 0, 0}).readings;
    EXPECT_NEAR(readings.sonar[0], 6 - 0.23 - readings.sonar_pose[0].x, 1e-6);
  }
}

TEST(Step, BumpersTellContact) {
  Sim sim(room(10, 4), {nomad(Pose2{9, 2, 0})}, {});
  const auto pressed = [&] {
    int count = 0;
    for (const auto bumper : sim.observation().readings.bumper) count += bumper;
    return count;
  };
  EXPECT_EQ(pressed(), 0);
  for (int i = 0; i < 12; ++i) sim.step({0.6, 0, 0});
  EXPECT_GE(pressed(), 1);
  EXPECT_EQ(sim.observation().readings.bumper.at(0), 1) << "the one in front";
}

/// Also where jitter makes the least period ten times shorter.
TEST(Step, PeriodsAreAtLeastAMillisecond) {
  for (const double period : {1e-12, 1e-9, 0.000999})
    EXPECT_THROW(Sim(room(20, 20), {nomad(Pose2{10, 10, 0})}, {.period = period}), ArgumentError) << period;
  Sim sim(room(20, 20), {nomad(Pose2{10, 10, 0})}, {.period = 0.001, .period_jitter = 1});
  for (int i = 0; i < 2000; ++i) sim.step({0.5, 0.2, 0});
  EXPECT_GT(sim.time(), 0.5);
  EXPECT_TRUE(sim.state().pose_world.position().allFinite());
  EXPECT_GT(sim.state().pose_world.x, 10.05);
}

TEST(Step, PeriodJitterKeepsTheMean) {
  Sim sim(room(20, 20), {nomad(Pose2{10, 10, 0})}, {.period = 0.1, .period_jitter = 0.2});
  double shortest = 1, longest = 0;
  for (int i = 0; i < 1000; ++i) {
    const double period = sim.step({0, 0, 0}).period;
    shortest = std::min(shortest, period);
    longest = std::max(longest, period);
  }
  EXPECT_NEAR(sim.time(), 100, 3);
  EXPECT_LT(shortest, 0.07);
  EXPECT_GT(longest, 0.13);
}

}  // namespace
}  // namespace meander
