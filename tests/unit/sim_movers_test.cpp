// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "sim_worlds.hpp"

namespace meander {
namespace {

Mover walker(const Vec2& at, std::vector<Vec2> waypoints, bool yields) {
  return {.name = "",
          .disc = {at, 0.25},
          .motion = waypoints.empty() ? Motion::random_walk : Motion::waypoints,
          .waypoints = std::move(waypoints),
          .speed = 0.5,
          .yields = yields};
}

/// Gap between the hulls of robot and mover.
double gap(const Sim& sim, std::size_t mover, std::size_t robot = 0) {
  return (sim.movers()[mover].position - sim.state(robot).pose_world.position()).norm() - 0.25 -
         sim.robot(robot).platform.body.radius;
}

TEST(Movers, GoRoundTheirStationsAtTheirSpeed) {
  auto world = room(10, 10);
  world->add(walker({1, 1}, {{3, 1}, {3, 2}}, true));
  Sim sim(world, {nomad(Pose2{8, 8, 0})}, {.period = 0.1});
  const double round = 2 + 1 + std::sqrt(5.0);
  double way = 0;
  for (int i = 1; i <= 300; ++i) {
    const Vec2 before = sim.movers()[0].position;
    sim.step(Command{});
    way += (sim.movers()[0].position - before).norm();
    const double along = std::fmod(0.05 * i, round);
    if (along < 2) {
      EXPECT_NEAR((sim.movers()[0].position - Vec2{1 + along, 1}).norm(), 0, 1e-9);
    }
  }
  EXPECT_NEAR(way, 15, 0.2);  // corners are cut within a cycle
}

TEST(Movers, RandomWalksPassThroughNothingAndKeepMoving) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    auto world = cluttered(seed);
    for (const Vec2& corner : {Vec2{3.6, 3.6}, Vec2{4.4, 4.4}, Vec2{3.6, 4.4}}) {
      Mover mover = walker(corner, {}, false);
      mover.disc.radius = 0.1;
      world->add(mover);
    }
    Sim sim(world, {nomad(Pose2{4, 4, 0})}, {.seed = seed});
    std::vector<double> ways(3);
    for (int i = 0; i < 300; ++i) {
      std::vector<Vec2> before;
      for (const MoverState& m : sim.movers()) before.push_back(m.position);
      sim.step({0.2, 0.3, 0});
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 at = sim.movers()[k].position;
        ways[k] += (at - before[k]).norm();
        for (const Id id : world->ids())
          if (const Shape* shape = blocking_shape(world->item(id))) {
            ASSERT_GE(distance(*shape, at), 0.1) << "seed " << seed << " step " << i << " " << name_of(world->item(id));
          }
        ASSERT_GE((at - sim.state().pose_world.position()).norm() - 0.1 - sim.robot().platform.body.radius, 0);
        ASSERT_TRUE(world->header().bounds.contains(at));
      }
    }
    for (const double way : ways) EXPECT_GT(way, 5) << "seed " << seed;
  }
}

TEST(Movers, AYieldingOneWaitsForTheRobotAndGoesOn) {
  auto world = room(10, 4);
  world->add(walker({2, 2}, {{8, 2}}, true));
  Sim sim(world, {nomad(Pose2{5, 2, kPi / 2})}, {.period = 0.1});
  for (int i = 0; i < 100; ++i) {
    sim.step(Command{});
    ASSERT_GT(gap(sim, 0), kYieldMargin - 0.06);
  }
  EXPECT_TRUE(sim.movers()[0].waiting);
  EXPECT_EQ(sim.state().contacts, 0);
  for (int i = 0; i < 40; ++i) sim.step({0.5, 0, 0});  // out of the way
  for (int i = 0; i < 100; ++i) sim.step(Command{});
  EXPECT_FALSE(sim.movers()[0].waiting);
}

TEST(Movers, ABlindOneThatHitsTheRobotIsNotItsFault) {
  auto world = room(10, 4);
  world->add(walker({2, 2}, {{8, 2}}, false));
  Sim sim(world, {nomad(Pose2{5, 2, 0})}, {.period = 0.1});
  for (int i = 0; i < 200; ++i) {
    sim.step(Command{});
    ASSERT_GE(gap(sim, 0), 0);
  }
  EXPECT_EQ(sim.state().contacts, 1);
  EXPECT_EQ(sim.state().fault_contacts, 0);
  EXPECT_TRUE(sim.state().touching);
  EXPECT_TRUE(sim.movers()[0].waiting);
}

TEST(Movers, DrivingIntoAStandingOneIs) {
  auto world = room(10, 4);
  world->add(walker({7, 2}, {{7, 2}}, false));
  Sim sim(world, {nomad(Pose2{5, 2, 0})}, {.period = 0.1});
  for (int i = 0; i < 100; ++i) {
    sim.step({0.5, 0, 0});
    ASSERT_GE(gap(sim, 0), 0);
  }
  EXPECT_EQ(sim.state().contacts, 1);
  EXPECT_EQ(sim.state().fault_contacts, 1);
}

TEST(Movers, StopAtAClosedDoorUntilItOpens) {
  auto world = room(10, 4);
  const Id door =
      world->add(Door{.name = "door", .shape = Chain{{{5, 0}, {5, 4}}, false}, .open = false, .surface = {}});
  world->add(walker({2, 2}, {{8, 2}}, true));
  Sim sim(world, {nomad(Pose2{9, 1, 0})}, {.period = 0.1});
  for (int i = 0; i < 100; ++i) sim.step(Command{});
  EXPECT_NEAR(sim.movers()[0].position.x(), 4.75, 1e-5);
  Door open = std::get<Door>(world->item(door));
  open.open = true;
  world->replace(door, open);
  for (int i = 0; i < 40; ++i) sim.step(Command{});
  EXPECT_GT(sim.movers()[0].position.x(), 5.5);
}

TEST(Movers, FollowTheEditsOfTheWorld) {
  auto world = room(10, 10);
  const Id first = world->add(walker({2, 2}, {{8, 2}}, true));
  Sim sim(world, {nomad(Pose2{5, 5, 0})}, {.period = 0.1});
  for (int i = 0; i < 20; ++i) sim.step(Command{});
  const Vec2 at = sim.movers()[0].position;
  const Id second = world->add(walker({2, 8}, {{8, 8}}, true));
  ASSERT_EQ(sim.movers().size(), 1u) << "edits take effect at the next step";
  sim.step(Command{});
  ASSERT_EQ(sim.movers().size(), 2u);
  EXPECT_NEAR((sim.movers()[0].position - at).norm(), 0.05, 1e-9) << "the old one goes on";
  Mover moved = std::get<Mover>(world->item(second));
  moved.disc.center = {5, 9};
  world->replace(second, moved);
  world->remove(first);
  sim.step(Command{});
  ASSERT_EQ(sim.movers().size(), 1u);
  EXPECT_NEAR((sim.movers()[0].position - Vec2{5, 9}).norm(), 0.05, 1e-9);
}

TEST(Robots, SeeAndTouchEachOther) {
  auto world = room(10, 4);
  RobotOptions left = nomad(Pose2{2, 2, 0}), right = nomad(Pose2{6, 2, kPi});
  left.sonar = right.sonar = sonar_preset("ideal");
  Sim sim(world, {left, right}, {.period = 0.1});
  const double expected = 4 - 0.23 - right.platform.body.radius;
  EXPECT_NEAR(sim.observation(0).readings.sonar[0], expected, 0.3);
  EXPECT_NEAR(sim.observation(1).readings.sonar[0], expected, 0.3);
  EXPECT_NEAR(sim.state(0).clearance, 2 - left.platform.body.radius, 1e-9);
  for (int i = 0; i < 100; ++i) {
    const std::vector<Command> commands{{0.5, 0, 0}, {0, 0, 0}};
    sim.step(commands);
    const double apart = (sim.state(0).pose_world.position() - sim.state(1).pose_world.position()).norm();
    ASSERT_GE(apart, 2 * left.platform.body.radius);
  }
  for (const std::size_t k : {0u, 1u}) {
    EXPECT_EQ(sim.state(k).contacts, 1);
    EXPECT_TRUE(sim.state(k).touching);
    EXPECT_EQ(sim.state(k).fault_contacts, k == 0 ? 1 : 0) << "who stands is not at fault";
  }
}

TEST(Robots, HeadOnIsNobodysFaultAlone) {
  auto world = room(10, 4);
  Sim sim(world, {nomad(Pose2{2, 2, 0}), nomad(Pose2{6, 2, kPi})}, {.period = 0.1});
  for (int i = 0; i < 100; ++i) {
    const std::vector<Command> commands{{0.5, 0, 0}, {0.5, 0, 0}};
    sim.step(commands);
  }
  EXPECT_EQ(sim.state(0).contacts, 1);
  EXPECT_EQ(sim.state(1).contacts, 1);
  EXPECT_EQ(sim.state(0).fault_contacts + sim.state(1).fault_contacts, 0);
}

}  // namespace
}  // namespace meander
