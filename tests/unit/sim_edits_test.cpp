// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Edits of the world while a simulation runs, and starts that are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_worlds.hpp"

namespace meander {
namespace {

Obstacle box(const Vec2& at, double size, std::string name = "box") {
  return {.name = std::move(name), .shape = Rectangle{at, {size, size}, 0}, .surface = {}};
}

TEST(Edits, TakeEffectAtTheNextStep) {
  auto world = room(10, 4);
  Sim sim(world, {nomad(Pose2{2, 2, 0})}, {});
  const double before = sim.observation().readings.sonar[0];
  world->add(box({4, 2}, 1));
  EXPECT_EQ(sim.observation().readings.sonar[0], before);
  EXPECT_LT(sim.step(Command{}).readings.sonar[0], 2);
  world->undo();
  EXPECT_GT(sim.step(Command{}).readings.sonar[0], 5);
}

TEST(Edits, AnObstacleOnTheRobotIsAContactItMayDriveOutOf) {
  auto world = room(10, 4);
  Sim sim(world, {nomad(Pose2{5, 2, 0})}, {});
  world->add(box({4.5, 2}, 0.6));  // its right edge is at 4.8, 0.067 m deep in the hull
  sim.step(Command{});
  EXPECT_TRUE(sim.state().touching);
  EXPECT_EQ(sim.state().contacts, 1);
  EXPECT_EQ(sim.state().fault_contacts, 0) << "the obstacle came";
  EXPECT_NEAR(sim.state().clearance, 0.2 - 0.2667, 1e-9);
  for (int i = 0; i < 10; ++i) sim.step({0.5, 0, 0});
  EXPECT_FALSE(sim.state().touching);
  EXPECT_GT(sim.state().pose_world.x, 5.5);
}

TEST(Edits, ButItMayNotGoDeeper) {
  auto world = room(10, 4);
  Sim sim(world, {nomad(Pose2{5, 2, kPi})}, {});
  world->add(box({4.5, 2}, 0.6));
  for (int i = 0; i < 10; ++i) sim.step({0.5, 0, 0});
  EXPECT_NEAR(sim.state().pose_world.x, 5, 1e-9);
}

TEST(Edits, BuriedRobotsFindOut) {
  auto world = room(10, 4);
  Sim sim(world, {nomad(Pose2{5, 2, 0})}, {});
  world->add(box({5, 2}, 1.2));
  sim.step({0.5, 0, 0});
  EXPECT_LT(sim.state().clearance, -0.5);
  for (int i = 0; i < 10; ++i) sim.step({0.5, 0, 0});
  EXPECT_FALSE(sim.state().touching);
  EXPECT_GT(sim.state().pose_world.x, 5.9);

  auto other = room(10, 4);
  Sim off_centre(other, {nomad(Pose2{5, 2, 0})}, {});
  other->add(box({5.3, 2}, 1.2));  // the way ahead leads deeper first
  for (int i = 0; i < 10; ++i) off_centre.step({0.5, 0, 0});
  EXPECT_NEAR(off_centre.state().pose_world.x, 5, 1e-9);
}

TEST(Edits, ADoorMayCloseAndOpen) {
  auto world = room(10, 4);
  const Id id = world->add(Door{.name = "door", .shape = Chain{{{6, 0}, {6, 4}}, false}, .open = true, .surface = {}});
  Sim sim(world, {nomad(Pose2{5, 2, 0})}, {});
  const auto set = [&](bool open) {
    Door door = std::get<Door>(world->item(id));
    door.open = open;
    world->replace(id, door);
  };
  set(false);
  for (int i = 0; i < 20; ++i) sim.step({0.5, 0, 0});
  EXPECT_LT(sim.state().pose_world.x, 6);
  set(true);
  for (int i = 0; i < 20; ++i) sim.step({0.5, 0, 0});
  EXPECT_GT(sim.state().pose_world.x, 7);
}

std::string refusal(const std::shared_ptr<World>& world, const std::vector<RobotOptions>& robots,
                    const SimOptions& options = {}) {
  try {
    Sim sim(world, robots, options);
  } catch (const ArgumentError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Start, SaysWhatIsWrongAndWhere) {
  auto world = room(10, 4);
  world->add(box({3, 2}, 1, "desk"));
  world->add(Mover{.name = "bob",
                   .disc = {{8, 2}, 0.3},
                   .motion = Motion::random_walk,
                   .waypoints = {},
                   .speed = 1,
                   .yields = true});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(world, {nomad(Pose2{3, 2.1, 0})}),
            "start (3.00, 2.10) is inside obstacle 'desk'; free space of the robot's radius 0.267 m expected");
  EXPECT_EQ(refusal(world, {nomad(Pose2{3.6, 2, 0})}),
            "start (3.60, 2.00) is 0.100 m from obstacle 'desk'; at least the robot's radius 0.267 m expected");
  EXPECT_EQ(refusal(world, {nomad(Pose2{8, 2.2, 0})}),
            "start (8.00, 2.20) is inside mover 'bob'; free space of the robot's radius 0.267 m expected");
  EXPECT_EQ(refusal(world, {nomad(Pose2{12, 2, 0})}),
            "start (12.00, 2.00) is outside the world's bounds (0.00, 0.00) to (10.00, 4.00)");
  EXPECT_EQ(refusal(world, {nomad(Pose2{1, nan, 0})}), "start: finite x, y and heading expected, got (1, nan, 0)");
  EXPECT_EQ(refusal(world, {nomad(Pose2{5, 2, 0}), nomad(Pose2{5.3, 2, 0})}),
            "robot 2: start (5.30, 2.00) overlaps robot 1 at (5.00, 2.00): 0.300 m apart, at least 0.533 m expected");
  EXPECT_EQ(refusal(world, {}), "at least one robot expected, got none");
  EXPECT_EQ(refusal(nullptr, {nomad()}), "a world expected, got none");
  EXPECT_EQ(refusal(std::make_shared<World>(), {nomad()}),
            "no start: the world has none, so the robot needs start = {x, y, heading}");
  RobotOptions fat = nomad();
  fat.platform.body.radius = -1;
  EXPECT_EQ(refusal(world, {fat}), "option 'platform.body.radius': a number from 0.01 to 10 [m] expected, got -1");
  EXPECT_NE(refusal(world, {nomad(Pose2{5, 2, 0})}, {.command_delay = -1}), "accepted");
  EXPECT_EQ(refusal(world, {nomad(Pose2{5, 2, 0})}), "accepted");
}

TEST(Start, OneCommandPerRobot) {
  Sim sim(room(10, 4), {nomad(Pose2{2, 2, 0}), nomad(Pose2{5, 2, 0})}, {});
  EXPECT_THROW(sim.step(Command{}), ArgumentError);
}

TEST(Start, AFailedResetLeavesTheRunAsItWas) {
  auto world = room(10, 4);
  Sim sim(world, {nomad(Pose2{2, 2, 0})}, {});
  for (int i = 0; i < 10; ++i) sim.step({0.5, 0, 0});
  world->add(box({2, 2}, 0.5));
  const std::uint64_t hash = sim.hash();
  EXPECT_THROW(sim.reset(), ArgumentError);
  EXPECT_EQ(sim.hash(), hash);
  EXPECT_NO_THROW(sim.step({0.5, 0, 0}));
}

}  // namespace
}  // namespace meander
