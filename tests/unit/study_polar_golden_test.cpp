// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Every bit of whole drives with the polar map: the same in every build, on every machine, from change to change. After
// a change that is meant to drive otherwise, run the test and copy the hashes that it reports into kGolden; a change of
// speed alone must leave them as they are.
#include <gtest/gtest.h>

#include "autonomy/subgoal_list.hpp"
#include "base/hash.hpp"
#include "polar/polar_navigator.hpp"
#include "sim_worlds.hpp"
#include "study/drive.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

struct Golden {
  const char* world;
  std::vector<std::string> places;
  const char* variant;
  const char* hashes[2];  ///< of seeds 1 and 2
};
const Golden kGolden[] = {
    {"u_trap", {"goal"}, "standard", {"82c639544d309bcb", "ae742160beb81a08"}},
    {"l_corner", {"goal"}, "32 sectors", {"5a2292c0c1adb758", "3ca2154bd1dff7e6"}},
    {"four_targets", {"target_1", "target_2"}, "late", {"945d9abc3c27d5e9", "015dd1680655cb47"}},
    {"clutter", {"goal"}, "log", {"358fc44fdbc1bb0c", "0457a257f990b0cc"}},
    {"clutter", {"north_west"}, "standard", {"fa41f530e83b6c8c", "ea1771c6ada2c4ef"}},
    {"office", {"door_a", "hall", "door_b"}, "standard", {"bb9255d85cd19d6e", "e6bfcba37fd52333"}},
    {"large_u", {"goal"}, "standard", {"3d3f2946665c32e0", "45feeeaab35246da"}},
    {"people", {"north_east"}, "real sonar", {"130b766b4bf2def2", "b98724e107759ad1"}},
    {"clutter", {"goal"}, "self-organising", {"af70accb941528f2", "30de2ce099989dfc"}},
    {"l_corner", {"goal"}, "paper", {"4dd95b29e0087603", "ffa7dc3ea091ed1b"}},
    {"l_corner", {"goal"}, "euclidean", {"d875b10488d668c6", "dc823165c70303bd"}},
};

PolarOptions options_of(const std::string& variant) {
  PolarOptions options;
  if (variant == "32 sectors") options.map.layout.sectors = 32;
  if (variant == "log") options.map.layout = {.rings = 32, .sectors = 32, .radii = PolarRadii::log};
  if (variant == "self-organising") {
    options.map.layout = {.rings = 40, .sectors = 24, .layout = PolarPlacing::self_organising};
  }
  if (variant == "paper") options.mode = PolarMode::paper;
  if (variant == "euclidean") {
    options.map.layout = {.rings = 30, .sectors = 24};
    options.map.weights = PolarWeights::euclidean;
  }
  return options;
}

/// Of every state of the run.
std::string hash_of(const Golden& golden, std::uint64_t seed) {
  auto world =
      std::make_shared<World>(read_world(std::string(MEANDER_SOURCE_DIR) + "/worlds/" + golden.world + ".toml"));
  std::vector<Subgoal> goals;
  for (const std::string& name : golden.places) {
    const Place& place = std::get<Place>(world->item(world->find(name)));
    goals.push_back({.position = place.position, .tolerance = place.tolerance, .heading = place.heading, .name = name});
  }
  const std::string variant = golden.variant;
  RobotOptions robot = nomad();
  if (variant == "real sonar") robot.sonar = sonar_preset("real");
  Sim sim(world, {robot}, {.seed = seed, .command_delay = variant == "late" ? 1 : 0});
  const Navigator navigator = polar_navigator(sim.robot().platform, options_of(variant));
  const Run run = drive(sim, navigator, subgoal_list(goals), {.time_limit = 120, .record_every = 0});
  return fmt::format("{:016x}", run.hash);
}

TEST(PolarGolden, DrivesHaveTheHashesThatTheyHad) {
  for (const Golden& golden : kGolden)
    for (const std::uint64_t seed : {1u, 2u})
      EXPECT_EQ(hash_of(golden, seed), golden.hashes[seed - 1])
          << golden.world << ", " << golden.variant << ", seed " << seed;
}

}  // namespace
}  // namespace meander
