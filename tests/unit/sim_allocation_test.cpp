// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>

#include "sim_worlds.hpp"

namespace meander {

std::size_t allocations();  // allocation_counter.cpp

namespace {

TEST(Step, AllocatesNothingOnceItRuns) {
  auto world = cluttered(7);
  world->add(Mover{.name = "",
                   .disc = {{3.3, 4}, 0.15},
                   .motion = Motion::random_walk,
                   .waypoints = {},
                   .speed = 0.4,
                   .yields = true});
  RobotOptions robot = nomad();
  robot.drift = drift_preset("good");
  Sim sim(world, {robot}, {.seed = 7, .command_delay = 1});
  Wanderer wanderer(7);
  for (int i = 0; i < 2000; ++i) sim.step(wanderer.next());
  for (int i = 0; i < 500; ++i) {
    const Command command = wanderer.next();
    const std::size_t before = allocations();
    sim.step(command);
    ASSERT_EQ(allocations() - before, 0u) << "step " << i;
  }
}

TEST(Step, AllocatesNothingInContact) {
  auto world = room(4, 4);
  world->add(Obstacle{.name = "", .shape = Disc{{3.8, 2}, 0.3}, .surface = {}});
  RobotOptions robot = nomad(Pose2{2, 2, 0});
  robot.platform.body.v_min = -0.5;
  Sim sim(world, {robot}, {.seed = 7});
  int pressed = 0;
  for (int i = 0; i < 150; ++i) {
    const Command to_and_fro{i % 40 < 25 ? 0.5 : -0.5, 0, 0};
    const std::size_t before = allocations();
    const auto& bumpers = sim.step(to_and_fro).readings.bumper;
    if (i < 40) continue;  // scans have to get to know the room
    ASSERT_EQ(allocations() - before, 0u) << "step " << i;
    pressed += std::count(bumpers.begin(), bumpers.end(), 1) > 0;
  }
  EXPECT_GT(pressed, 20);
  EXPECT_LT(pressed, 90) << "comes and goes";
}

}  // namespace
}  // namespace meander
