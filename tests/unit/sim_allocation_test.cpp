// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "sim_worlds.hpp"

namespace meander {

std::size_t allocations();  // sim_allocation_counter_test.cpp

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
    if (sim.state().clearance < 2e-3) continue;  // then the bumpers look at what they touch
    ASSERT_EQ(allocations() - before, 0u) << "step " << i;
  }
}

}  // namespace
}  // namespace meander
