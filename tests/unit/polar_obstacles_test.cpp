// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "polar/echo.hpp"
#include "polar/polar_navigator.hpp"

namespace meander {
namespace {

Observation seeing_nothing(const Pose2& pose) {
  Observation observation;
  observation.period = 0.33;
  observation.odometry = {pose, 0, 0};
  observation.readings.sonar.assign(16, 6.477);
  observation.readings.sonar_pose.assign(16, pose);
  return observation;
}

TEST(PolarObstacles, OfOnesOwnTakeThePlaceOfTheMemory) {
  const Pose2 pose{3, -2, 0.4};
  int calls = 0;
  const PolarParts parts{.weights = {},
                         .objective = {},
                         .subgoal = {},
                         .obstacles = [&](const Observation& seen, std::vector<Vec2>& points) {
                           ++calls;
                           points.clear();
                           for (int k = -6; k <= 6; ++k) points.push_back(seen.odometry.pose * Vec2(1, 0.1 * k));
                         }};
  const Platform& nomad = platform("nomad200");
  PolarNavigator walled(nomad, {}, parts), open(nomad, {});
  const Subgoal ahead{.position = pose * Vec2(2.2, 0.01), .tolerance = 0.1, .heading = {}, .name = {}};
  walled.step(seeing_nothing(pose), ahead);
  open.step(seeing_nothing(pose), ahead);
  EXPECT_EQ(calls, 1);
  EXPECT_GT(walled.points().size(), 6U);
  EXPECT_EQ(open.points().size(), 0U);
  ASSERT_TRUE(open.subgoal() && walled.subgoal());
  EXPECT_EQ(open.subgoal()->sector, 0) << "straight on";
  EXPECT_NE(walled.subgoal()->sector, 0) << "around the wall that only the list tells of";
}

TEST(PolarObstacles, SilenceOfShortSonarsIsNoWall) {
  Observation seen = seeing_nothing({});
  seen.readings.sonar.assign(16, 1.5);
  const Platform& nomad = platform("nomad200");
  SonarMemory memory(nomad, {});
  memory.remember(seen.readings);
  EXPECT_EQ(memory.scan(0).size(), 16U);
  std::vector<Echo> echoes;
  read_echoes(seen, nomad, {}, echoes);
  EXPECT_EQ(echoes.size(), 16U);
  seen.readings.sonar_max = 1.5;
  seen.readings.sonar[4] = 0.8;
  memory.remember(seen.readings);
  EXPECT_EQ(memory.scan(0).size(), 1U);
  read_echoes(seen, nomad, {}, echoes);
  EXPECT_EQ(echoes.size(), 1U);
}

}  // namespace
}  // namespace meander
