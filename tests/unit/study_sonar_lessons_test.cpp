// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/sonar_lessons.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace meander {
namespace {

World empty_world(const Vec2& size) {
  Header header;
  header.bounds = {{0, 0}, size};
  return World(header);
}

/// A room of 4 x 4 m, and one behind its eastern wall.
World two_rooms() {
  World world = empty_world({8, 4});
  world.add(Obstacle{.name = "walls", .shape = Chain{{{0, 0}, {8, 0}, {8, 4}, {0, 4}, {0, 0}}}, .surface = {}});
  world.add(Obstacle{.name = "between", .shape = Chain{{{4, 0}, {4, 4}}}, .surface = {}});
  return world;
}

RobotOptions robot() {
  RobotOptions options;
  options.platform = platform("nomad200");
  options.sonar = sonar_preset("ideal");
  return options;
}

TEST(SonarLessons, TellWhatIsSeen) {
  SonarLessons lessons;
  add_lessons(lessons, two_rooms(), robot(), {.poses = 20, .occupied = 1, .free = 1, .hidden = 1});
  EXPECT_EQ(lessons.scans(), 20u);
  int counts[3] = {};
  for (const SonarLessons::Cell& cell : lessons.cells) {
    ++counts[static_cast<int>(cell.truth)];
    EXPECT_GT(cell.range, 0.2667F);
    EXPECT_LT(cell.range, 2.2F);
    EXPECT_LE(std::abs(cell.bearing), 3.1416F);
  }
  for (const int count : counts) EXPECT_GT(count, 100);
  EXPECT_GT(counts[static_cast<int>(CellTruth::free)], 5 * counts[static_cast<int>(CellTruth::occupied)]);
}

TEST(SonarLessons, SharesAreTakenAndSeedsRepeat) {
  SonarLessons all, some, again, other;
  const LessonOptions every{.poses = 10, .occupied = 1, .free = 1, .hidden = 0};
  LessonOptions tenth = every;
  tenth.free = tenth.occupied = 0.1;
  add_lessons(all, two_rooms(), robot(), every);
  add_lessons(some, two_rooms(), robot(), tenth);
  add_lessons(again, two_rooms(), robot(), tenth);
  tenth.seed = 2;
  add_lessons(other, two_rooms(), robot(), tenth);
  EXPECT_NEAR(static_cast<double>(some.cells.size()) / static_cast<double>(all.cells.size()), 0.1, 0.01);
  EXPECT_EQ(some.ranges, all.ranges);
  ASSERT_EQ(some.cells.size(), again.cells.size());
  for (std::size_t i = 0; i < some.cells.size(); ++i) EXPECT_EQ(some.cells[i].range, again.cells[i].range);
  EXPECT_NE(some.ranges, other.ranges);
}

TEST(SonarLessons, MistakesAreRefused) {
  SonarLessons lessons;
  add_lessons(lessons, two_rooms(), robot(), {.poses = 1});
  RobotOptions scout = robot();
  scout.platform = platform("scout");
  EXPECT_THROW(add_lessons(lessons, two_rooms(), scout, {.poses = 1}), ArgumentError);
  EXPECT_THROW(add_lessons(lessons, two_rooms(), robot(), {.poses = 0}), ArgumentError);
  World narrow = empty_world({0.5, 0.5});
  narrow.add(Obstacle{.name = "", .shape = Chain{{{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}, {0, 0}}}, .surface = {}});
  SonarLessons none;
  EXPECT_THROW(add_lessons(none, narrow, robot(), {.poses = 1}), ArgumentError);
  StopToken stop;
  stop.request();
  EXPECT_THROW(add_lessons(none, two_rooms(), robot(), {}, {.stop = &stop, .progress = {}}), Cancelled);
}

}  // namespace
}  // namespace meander
