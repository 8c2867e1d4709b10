// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The explorer by sonar where its navigator hardly gets through: in corridors of three radii.
#include <gtest/gtest.h>

#include "autonomy/sonar_explorer.hpp"
#include "labyrinth_robot.hpp"
#include "polar/polar_navigator.hpp"
#include "study/drive.hpp"
#include "world/generate_labyrinth.hpp"

namespace meander {
namespace {

constexpr int kSide = 6;
constexpr double kCorridor = 0.8;

TEST(SonarExplorerInNarrowCorridors, WhereItWasStoppedIsNoReasonToSayThatNoWayIsLeft) {
  const RobotOptions robot = labyrinth_robot(kCorridor / 3);
  int stopped = 0;
  for (const std::uint64_t seed : {9u, 15u, 18u, 19u}) {
    const Labyrinth cells = make_labyrinth({.seed = seed, .columns = kSide, .rows = kSide, .loops = 0.08});
    const Vec2 goal((kSide - 0.5) * kCorridor, (kSide - 0.5) * kCorridor);
    const auto explorer = std::make_shared<SonarExplorer>(goal, robot.platform);
    SimOptions options;
    options.seed = 10 * seed + 1;
    Sim sim(std::make_shared<World>(labyrinth_world(cells, {.corridor = kCorridor}, seed)), {robot}, options);
    drive(sim, polar_navigator(robot.platform, {}), exploring_guide(explorer), {.time_limit = 2000, .record_every = 0});
    EXPECT_NE(explorer->ending(), Ending::no_passable_direction) << "seed " << seed << ": " << explorer->reason();
    EXPECT_EQ(explorer->ending(), Ending::reached) << "seed " << seed << ": " << explorer->reason();
    stopped += explorer->blocked();
  }
  EXPECT_GE(stopped, 4);
}

}  // namespace
}  // namespace meander
