// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The sonar map from observations made by hand, and the explorer as a guide. Whole drives are in
// examples/labyrinth.lua.
#include "autonomy/sonar_explorer_text.hpp"

#include <gtest/gtest.h>

#include "geometry/angle.hpp"

namespace meander {
namespace {

/// What the ring of a robot reads that stands in a square room, its walls 2 m from the origin: the nearest point of the
/// walls in each cone, noise-free.
Observation in_room(const Platform& robot, const Vec2& at, double time) {
  Observation seen;
  seen.time = time;
  seen.odometry.pose = {at.x(), at.y(), 0};
  for (int i = 0; i < robot.sonar.count; ++i) {
    const double bearing = 2 * kPi * i / robot.sonar.count;
    double reading = 6.477;
    for (int ray = -10; ray <= 10; ++ray) {
      const SinCos axis = sin_cos(bearing), way = sin_cos(bearing + radians(1.25) * ray);
      const Vec2 from = at + robot.sonar.radius * Vec2(axis.cos, axis.sin);
      for (const auto& [place, along] : {std::pair{from.x(), way.cos}, std::pair{from.y(), way.sin}})
        if (std::abs(along) > 1e-9) reading = std::min(reading, ((along > 0 ? 2 : -2) - place) / along);
    }
    seen.readings.sonar.push_back(reading);
    seen.readings.sonar_pose.push_back(seen.odometry.pose);
  }
  return seen;
}

TEST(SonarOccupancy, ARoomIsFreeAndItsWallsAreFoundNearByAndOnTheMove) {
  const Platform& robot = platform("nomad200");
  SonarOccupancy map(robot);
  for (int i = 0; i <= 20; ++i) map.update(in_room(robot, {0.05 * i, 0}, i));
  const ConfigurationSpace& space = map.space();
  EXPECT_TRUE(space.free(space.frame().cell({0, 0})));
  EXPECT_EQ(space.known(space.frame().cell({-1, 0.5})), Known::free);
  EXPECT_TRUE(space.blocked(space.frame().cell({1.9, 0})));  // it came near that wall
  EXPECT_EQ(space.known(space.frame().cell({2.5, 0})), Known::nothing);
}

TEST(SonarOccupancy, StandingStillTellsOfNoWall) {
  const Platform& robot = platform("nomad200");
  SonarOccupancy map(robot);
  for (int i = 0; i <= 50; ++i) map.update(in_room(robot, {1, 0}, i));
  for (double x = 1.5; x < 2.2; x += 0.05) EXPECT_NE(map.space().known(map.space().frame().cell({x, 0})), Known::wall);
}

TEST(SonarOccupancy, ABumperIsBelievedAtOnce) {
  const Platform& robot = platform("nomad200");
  SonarOccupancy map(robot);
  Observation seen = in_room(robot, {0, 0}, 0);
  seen.readings.bumper.assign(20, 0);
  seen.readings.bumper[0] = 1;
  map.update(seen);
  const Cell ahead = map.space().frame().cell({robot.body.radius + 0.05, 0});
  EXPECT_EQ(map.space().known(ahead), Known::wall);
  EXPECT_FALSE(map.weak(ahead));
}

TEST(SonarOccupancy, WhatIsKnownStaysWhereItIsWhenTheMapGrows) {
  const Platform& robot = platform("nomad200");
  SonarOccupancy map(robot);
  for (int i = 0; i <= 10; ++i) map.update(in_room(robot, {0.05 * i, 0}, i));
  const int frames = map.frames();
  std::vector<Known> before, after;
  const auto look = [&](std::vector<Known>& into) {
    for (double x = -3; x < 3; x += 0.05)
      for (double y = -3; y < 3; y += 0.05)
        into.push_back(map.space().known(map.space().frame().cell({x + 0.02, y + 0.02})));
  };
  look(before);
  map.include({-40, 30});
  EXPECT_GT(map.frames(), frames);
  look(after);
  EXPECT_EQ(before, after);
}

TEST(SonarExplorer, InARoomItDrivesStraightToItsGoalAndSaysSo) {
  const Platform& robot = platform("nomad200");
  for (const auto strategy : {ExplorationStrategy::indicators, ExplorationStrategy::dstar_lite,
                              ExplorationStrategy::frontier, ExplorationStrategy::goal_frontier}) {
    SonarExplorerOptions options;
    options.strategy = strategy;
    SonarExplorer explorer({1, 0.5}, robot, options);
    Vec2 at(-1, -0.5);
    GuideStep step;
    for (int i = 0; i < 2000; ++i) {
      step = explorer.next(in_room(robot, at, i * robot.period), {});
      if (!step.subgoal) break;
      const Vec2 way = step.subgoal->position - at;
      if (way.norm() > 0.05) at += way * (0.05 / way.norm());
    }
    EXPECT_FALSE(step.subgoal);
    EXPECT_EQ(explorer.ending(), Ending::reached) << to_string(strategy) << ": " << explorer.reason();
    EXPECT_LT((at - Vec2(1, 0.5)).norm(), 0.3);
  }
}

TEST(SonarExplorer, IsKnownByItsGuide) {
  const auto explorer = std::make_shared<SonarExplorer>(Vec2(1, 0.5), platform("nomad200"));
  const Guide guide = exploring_guide(explorer), other{.name = "explorer", .next = {}};
  EXPECT_EQ(explorer_of(guide), explorer);
  EXPECT_EQ(explorer_of(other), nullptr);
}

TEST(SonarExplorer, IsReadAsItWasWrittenAndAFileThatIsCutOffIsRefused) {
  const Platform& robot = platform("nomad200");
  for (const PortPerception perception : {PortPerception::map, PortPerception::profile}) {
    SonarExplorerOptions options;
    options.perception = perception;
    SonarExplorer explorer({1, 0.5}, robot, options);
    Vec2 at(-1, 0);
    for (int i = 0; i < 60; ++i) {
      const GuideStep step = explorer.next(in_room(robot, at, i * robot.period), {});
      if (step.subgoal && (step.subgoal->position - at).norm() > 0.05)
        at += (step.subgoal->position - at).normalized() * 0.05;
    }
    const std::string text = to_text(explorer);
    EXPECT_EQ(to_text(*sonar_explorer_from_text(text)), text);
    for (std::size_t length = 0; length + 1 < text.size(); length += 1 + text.size() / 300)
      EXPECT_THROW(sonar_explorer_from_text(text.substr(0, length)), FileError) << length;
  }
}

TEST(SonarExplorer, AGoalBeyondTheWallsIsGivenUpInWords) {
  const Platform& robot = platform("nomad200");
  SonarExplorer explorer({4, 0}, robot);
  Vec2 at(0, 0);
  for (int i = 0; i < 20000 && explorer.ending() == Ending::driving; ++i) {
    const GuideStep step = explorer.next(in_room(robot, at, i * robot.period), {});
    if (!step.subgoal) break;
    const Vec2 way = step.subgoal->position - at;
    Vec2 to = at;
    if (way.norm() > 0.05) to += way * (0.05 / way.norm());
    const double room = 2 - robot.body.radius - 0.02;
    at = to.cwiseMax(Vec2(-room, -room)).cwiseMin(Vec2(room, room));
  }
  EXPECT_EQ(explorer.ending(), Ending::no_passable_direction) << explorer.reason();
}

TEST(SonarExplorer, AFrontierIsGivenUpOnlyAfterADriveToIt) {
  const Platform& robot = platform("nomad200");
  SonarExplorerOptions options;
  options.strategy = ExplorationStrategy::frontier;
  SonarExplorer explorer({1.2, 0.5}, robot, options);
  for (int i = 0; i < 3; ++i) explorer.next(in_room(robot, {0, 0}, i * robot.period), {});
  const ConfigurationSpace& space = explorer.map().space();
  for (double x = -0.5; x <= 0.5; x += 0.05)
    for (double y = -0.5; y <= 0.5; y += 0.05)
      EXPECT_NE(space.known(space.frame().cell({x, y})), Known::wall) << x << " " << y;
}

TEST(SonarExplorer, AGoalWhoseCellIsReachedAndWhichItselfIsNotIsDrivenTo) {
  const Platform& robot = platform("nomad200");
  const Vec2 goal(0.1999, 0.0499);  // its cell's centre is within `arrive` of the origin
  for (const auto strategy : {ExplorationStrategy::frontier, ExplorationStrategy::goal_frontier}) {
    SonarExplorerOptions options;
    options.strategy = strategy;
    SonarExplorer explorer(goal, robot, options);
    int cycle = 0;
    for (double y = -1.5; y <= 1.5; y += 0.25)
      for (double x = -1.5; x <= 1.5; x += 0.1) explorer.next(in_room(robot, {x, y}, ++cycle * robot.period), {});
    explorer.begin();
    const GuideStep step = explorer.next(in_room(robot, {0, 0}, ++cycle * robot.period), {});
    ASSERT_TRUE(step.subgoal) << to_string(strategy) << ": " << step.reason;
    EXPECT_LT((step.subgoal->position - goal).norm(), 0.1);
    const GuideStep trapped = explorer.next(in_room(robot, {0.05, 0}, ++cycle * robot.period),
                                            {.command = {}, .status = NavigatorStatus::trapped, .reason = {}});
    EXPECT_FALSE(trapped.subgoal);
    EXPECT_EQ(explorer.ending(), Ending::reached) << explorer.reason();
  }
}

TEST(SonarExplorer, AGoalBesideAWallIsReachedAsNearAsARobotCanStandToIt) {
  const Platform& robot = platform("nomad200");
  const Vec2 goal(1.8, 0);  // the robot's centre can be at 1.73
  for (const auto strategy : {ExplorationStrategy::indicators, ExplorationStrategy::dstar_lite,
                              ExplorationStrategy::frontier, ExplorationStrategy::goal_frontier}) {
    SonarExplorerOptions options;
    options.strategy = strategy;
    SonarExplorer explorer(goal, robot, options);
    Vec2 at(-1, 0.5);
    for (int i = 0; i < 4000 && explorer.ending() == Ending::driving; ++i) {
      const GuideStep step = explorer.next(in_room(robot, at, i * robot.period), {});
      if (!step.subgoal) break;
      const Vec2 way = step.subgoal->position - at;
      Vec2 to = at;
      if (way.norm() > 0.05) to += way * (0.05 / way.norm());
      const double room = 2 - robot.body.radius;
      at = to.cwiseMax(Vec2(-room, -room)).cwiseMin(Vec2(room, room));
    }
    EXPECT_EQ(explorer.ending(), Ending::reached) << to_string(strategy) << ": " << explorer.reason();
    EXPECT_LE((at - goal).norm(), options.explorer.tolerance);
  }
}

TEST(SonarExplorer, AGoalTooFarAwayIsNamed) {
  const Platform& robot = platform("nomad200");
  for (const double far : {1e6, 1e12}) {
    SonarExplorer explorer({far, 0}, robot);
    try {
      explorer.next(in_room(robot, {0, 0}, 0), {});
      FAIL() << far;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(fmt::format("goal: ({:g}, 0)", far)), std::string::npos) << error.what();
    }
  }
}

TEST(SonarExplorer, ARobotWithoutSonarsIsRefused) {
  Platform deaf = platform("nomad200");
  deaf.sonar.count = 0;
  EXPECT_THROW(SonarExplorer({4, 0}, deaf), ArgumentError);
}

TEST(SecondLook, ComesToAnEndAndLeavesTheMapAsItIs) {
  const Platform& robot = platform("nomad200");
  SonarOccupancy map(robot);
  for (int i = 0; i < 3; ++i) map.update(in_room(robot, {0, 0}, i));
  map.include({6, 0});
  const auto walls = [&] {
    int count = 0;
    for (int y = 0; y < map.space().height(); ++y)
      for (int x = 0; x < map.space().width(); ++x) count += map.space().known({x, y}) == Known::wall;
    return count;
  };
  const int before = walls();
  SecondLook look;
  std::vector<Vec2> places;
  while (const auto place = look.next(map, {0, 0}, {6, 0}, 0.2)) {
    places.push_back(*place);
    ASSERT_EQ(places.size(), static_cast<std::size_t>(look.count()));
    ASSERT_LT(places.size(), 1000u);  // nothing new is ever heard
  }
  EXPECT_GT(places.size(), 3u);
  EXPECT_LE(walls(), before);
}

static_assert(!std::is_copy_constructible_v<SonarExplorer> && !std::is_move_constructible_v<SonarExplorer>);

}  // namespace
}  // namespace meander
