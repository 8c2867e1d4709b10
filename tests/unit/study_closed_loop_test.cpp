// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The potential field in whole drives: what it can, and what it is known not to.
#include <gtest/gtest.h>

#include <algorithm>

#include "autonomy/navigators.hpp"
#include "autonomy/subgoal_list.hpp"
#include "sim_worlds.hpp"
#include "study/drive.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

/// Seeds of the tuning were 1 to 20.
constexpr std::uint64_t kFirstSeed = 1001;

Run run_in(const std::string& name, const std::vector<std::string>& places, std::uint64_t seed) {
  auto world = std::make_shared<World>(read_world(std::string(MEANDER_SOURCE_DIR) + "/worlds/" + name + ".toml"));
  std::vector<Subgoal> goals;
  for (const std::string& place : places) {
    const Place& p = std::get<Place>(world->item(world->find(place)));
    goals.push_back({.position = p.position, .tolerance = p.tolerance, .heading = p.heading, .name = p.name});
  }
  Sim sim(world, {nomad()}, {.seed = seed});
  return drive(sim, navigator_by_name("potential_field", sim.robot().platform), subgoal_list(goals),
               {.time_limit = 300});
}

TEST(ClosedLoop, CrossesOpenRoomsWithPolesWithoutTouching) {
  for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + 20; ++seed) {
    auto world = room(12, 12);
    Stream random(seed, "poles");
    std::vector<Vec2> poles;
    while (poles.size() < 6) {  // far enough apart to pass between any two
      const Vec2 at{random.uniform(2.5, 9.5), random.uniform(2.5, 9.5)};
      if (std::any_of(poles.begin(), poles.end(), [&](const Vec2& p) { return (p - at).norm() < 2; })) continue;
      poles.push_back(at);
      world->add(Obstacle{.name = "", .shape = Disc{at, random.uniform(0.15, 0.3)}, .surface = {}});
    }
    Sim sim(world, {nomad(Pose2{1, 1, 0.5})}, {.seed = seed});
    const auto goals = subgoal_list({{.position = {11, 11}, .tolerance = 0.25, .heading = {}, .name = {}},
                                     {.position = {11, 1}, .tolerance = 0.25, .heading = {}, .name = {}},
                                     {.position = {1, 11}, .tolerance = 0.25, .heading = {}, .name = {}}});
    const auto run = drive(sim, navigator_by_name("potential_field", sim.robot().platform), goals);
    EXPECT_TRUE(run.success) << "seed " << seed << ": " << run.reason;
    EXPECT_EQ(run.contacts, 0) << "seed " << seed;
  }
}

TEST(ClosedLoop, CrossesTheOfficeThroughItsDoors) {
  for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + 20; ++seed) {
    const auto run = run_in("office", {"door_a", "hall", "door_b"}, seed);
    EXPECT_TRUE(run.success) << "seed " << seed << ": " << run.reason;
    EXPECT_EQ(run.contacts, 0) << "seed " << seed;
  }
}

TEST(ClosedLoop, IsTrappedInTheUAndSaysSo) {
  for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + 5; ++seed) {
    const auto run = run_in("u_trap", {"goal"}, seed);
    EXPECT_FALSE(run.success);
    EXPECT_NE(run.reason.find("trapped on the way to subgoal 1 'goal'"), std::string::npos) << run.reason;
    EXPECT_EQ(run.contacts, 0);
  }
}

}  // namespace
}  // namespace meander
