// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <thread>

#include "sim_worlds.hpp"

namespace meander {
namespace {

/// A world with everything in it: walls, poles, a door, movers of each kind; two robots that drift and see with noise.
Sim busy(std::uint64_t seed) {
  auto world = cluttered(3);
  world->add(Door{.name = "door", .shape = Chain{{{1, 4}, {1.5, 4}}, false}, .open = false, .surface = {}});
  world->add(Mover{.name = "",
                   .disc = {{3.2, 4}, 0.15},
                   .motion = Motion::random_walk,
                   .waypoints = {},
                   .speed = 0.4,
                   .yields = true});
  world->add(Mover{.name = "",
                   .disc = {{4.9, 4}, 0.15},
                   .motion = Motion::waypoints,
                   .waypoints = {{4.9, 5}},
                   .speed = 0.3,
                   .yields = false});
  RobotOptions first = nomad(Pose2{4, 4, 0}), second = nomad(Pose2{4, 4.7, 1});
  first.sonar = sonar_preset("nomad");
  second.sonar = sonar_preset("real");
  first.drift = drift_preset("poor");
  return Sim(world, {first, second}, {.seed = seed, .period_jitter = 0.1, .command_delay = 1});
}

class Drivers {
 public:
  explicit Drivers(std::uint64_t seed) : first_(seed), second_(seed + 1000) {}
  void step(Sim& sim) {
    const std::vector<Command> commands{first_.next(), second_.next()};
    sim.step(commands);
  }

 private:
  Wanderer first_, second_;
};

std::vector<std::uint64_t> hashes(Sim& sim, Drivers drivers, int steps) {
  std::vector<std::uint64_t> found;
  for (int i = 0; i < steps; ++i) {
    drivers.step(sim);
    found.push_back(sim.hash());
  }
  return found;
}

TEST(Determinism, SameSeedSameHashAndAnotherSeedAnother) {
  Sim a = busy(1), b = busy(1), c = busy(2);
  EXPECT_EQ(a.hash(), b.hash());
  EXPECT_EQ(hashes(a, Drivers(1), 100), hashes(b, Drivers(1), 100));
  EXPECT_NE(a.hash(), c.hash());
}

TEST(Determinism, GoldenHash) {
  // Holds in Debug and Release and on every machine. A change of the simulation changes it on purpose, or is a bug.
  Sim sim = busy(1);
  EXPECT_EQ(Hash().add(hashes(sim, Drivers(1), 200).back()).hex(), "e324559169124b0f");
}

TEST(Determinism, ResetIsTheSameRunAgain) {
  Sim sim = busy(1);
  const auto first = hashes(sim, Drivers(1), 60);
  sim.reset();
  EXPECT_EQ(hashes(sim, Drivers(1), 60), first);
  sim.reset(2);
  Sim other = busy(2);
  EXPECT_EQ(hashes(sim, Drivers(1), 60), hashes(other, Drivers(1), 60));
}

TEST(Determinism, AForkGoesOnAloneAndAlike) {
  Sim sim = busy(1);
  Drivers drivers(1);
  for (int i = 0; i < 40; ++i) drivers.step(sim);
  Sim fork = sim.fork();
  EXPECT_EQ(fork.hash(), sim.hash());
  Sim undisturbed = sim.fork();
  const auto in_fork = hashes(fork, drivers, 60);
  fork.shared_world()->add(Obstacle{.name = "", .shape = Disc{{7.9, 7.9}, 0.05}, .surface = {}});
  fork.step(std::vector<Command>(2));
  EXPECT_EQ(hashes(sim, drivers, 60), in_fork) << "the fork's own steps and edits must not be felt";
  EXPECT_EQ(hashes(undisturbed, drivers, 60), in_fork);
}

TEST(Determinism, EditsThatWereUndoneLeaveNoTrace) {
  Sim plain = busy(1), edited = busy(1);
  Drivers one(1), other(1);
  for (int i = 0; i < 60; ++i) {
    one.step(plain);
    if (i % 7 == 3) {
      World& world = *edited.shared_world();
      const Id id = world.add(Obstacle{.name = "", .shape = Disc{{6, 6}, 0.5}, .surface = {}});
      world.remove(world.ids().front());
      world.replace(id, Obstacle{.name = "x", .shape = Rectangle{{6.5, 4}, {1, 1}, 0}, .surface = {}});
      ASSERT_EQ(world.undo(3), 3);
    }
    other.step(edited);
    ASSERT_EQ(plain.hash(), edited.hash()) << i;
  }
}

TEST(Determinism, RedoneEditsActAlike) {
  Sim once = busy(1), twice = busy(1);
  for (Sim* sim : {&once, &twice})
    sim->shared_world()->add(Obstacle{.name = "", .shape = Rectangle{{6, 4}, {0.2, 2}, 0}, .surface = {}});
  twice.shared_world()->undo();
  twice.shared_world()->redo();
  EXPECT_EQ(hashes(once, Drivers(1), 60), hashes(twice, Drivers(1), 60));
}

TEST(Determinism, ManyAtOnceInThreadsEqualOneAlone) {
  Sim alone = busy(1);
  const auto expected = hashes(alone, Drivers(1), 100);
  std::vector<std::vector<std::uint64_t>> found(4);
  {
    std::vector<std::jthread> threads;
    for (auto& mine : found)
      threads.emplace_back([&mine] {
        Sim sim = busy(1);
        mine = hashes(sim, Drivers(1), 100);
      });
  }
  for (const auto& mine : found) EXPECT_EQ(mine, expected);
}

TEST(Determinism, TheHashSeesEveryPart) {
  Sim sim = busy(1);
  Drivers(1).step(sim);
  const std::uint64_t before = sim.hash();
  Sim world_changed = sim.fork();
  world_changed.shared_world()->add(Light{.name = "", .position = {1, 1}, .strength = 1});
  EXPECT_NE(world_changed.hash(), before);
  Sim stepped = sim.fork();
  stepped.step(std::vector<Command>(2));
  EXPECT_NE(stepped.hash(), before);
  EXPECT_EQ(sim.hash(), before);
}

}  // namespace
}  // namespace meander
