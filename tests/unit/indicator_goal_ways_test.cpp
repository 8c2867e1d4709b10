// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// How far it is to the goal at least, against the fine field, while walls come and go.
#include "indicator/goal_ways.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace meander {
namespace {

TEST(GoalWays, NoWayIsShorterThanTheyTell) {
  Stream random(5, "ways");
  for (int trial = 0; trial < 10; ++trial) {
    ConfigurationSpace map(130, 110, {0.05, {1, 2, 0}}, 0.1);
    const Vec2 goal = map.frame().center({random.below(130), random.below(110)});
    GoalWays ways;
    GeodesicField field;
    for (int round = 0; round < 5; ++round) {
      for (int wall = 0; wall < 12; ++wall) {
        const bool along = random.below(2) == 0;
        const Cell from{random.below(130), random.below(110)};
        const Known known = random.below(4) == 0 ? Known::nothing : random.below(3) == 0 ? Known::free : Known::wall;
        for (int i = 0; i < 50; ++i) map.set(along ? Cell{from.x + i, from.y} : Cell{from.x, from.y + i}, known);
      }
      ways.update(map, goal);
      field.spread(map, map.frame().cell(goal), 1e6, true);
      for (int y = 0; y < 110; ++y)
        for (int x = 0; x < 130; ++x) {
          const Vec2 from = map.frame().center({x, y});
          if (map.open({x, y})) {
            EXPECT_LE(ways.least(from), 1.0102 * field.at({x, y}) + 1e-9);  // 1.4 of the field for the root of 2
          }
          EXPECT_GE(ways.least(from), (from - goal).norm());
        }
    }
  }
}

TEST(GoalWays, WhatIsShutInLeadsNowhere) {
  ConfigurationSpace map(200, 80, {0.05, {}}, 0.225);
  for (int y = 0; y < 80; ++y) map.set({100, y}, Known::wall);
  GoalWays ways;
  ways.update(map, {8, 2});
  EXPECT_FALSE(std::isfinite(ways.least({2, 2})));
  EXPECT_NEAR(ways.least({9, 2}), 1, 1e-9);
  for (int y = 60; y < 80; ++y) map.set({100, y}, Known::nothing);
  ways.update(map, {8, 0.5});
  EXPECT_GT(ways.least({2, 0.5}), 6.8);  // round by the opening above, not straight on
  EXPECT_LT(ways.least({2, 0.5}), 8.2);
}

TEST(GoalWays, WhereAWallIsSaidToStandOnTheGoalTheyTellTheStraightWay) {
  ConfigurationSpace map(200, 80, {0.05, {}}, 0.225);
  map.set({160, 40}, Known::wall);
  GoalWays ways;
  ways.update(map, map.frame().center({160, 40}));
  EXPECT_NEAR(ways.least(map.frame().center({60, 40})), 5, 1e-9);
}

}  // namespace
}  // namespace meander
