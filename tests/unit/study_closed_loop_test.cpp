// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Navigators in whole drives: what they can, and what they are known not to.
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

Run run_in(const std::string& name, const std::vector<std::string>& places, std::uint64_t seed,
           const std::string& navigator = "potential_field", int command_delay = 0, double hand_over = 0) {
  auto world = std::make_shared<World>(read_world(std::string(MEANDER_SOURCE_DIR) + "/worlds/" + name + ".toml"));
  std::vector<Subgoal> goals;
  for (const std::string& place : places) {
    const Place& p = std::get<Place>(world->item(world->find(place)));
    goals.push_back({.position = p.position, .tolerance = p.tolerance, .heading = p.heading, .name = p.name});
  }
  Sim sim(world, {nomad()}, {.seed = seed, .command_delay = command_delay});
  return drive(sim, navigator_by_name(navigator, sim.robot().platform), subgoal_list(goals, {.hand_over = hand_over}),
               {.time_limit = 600});
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

struct Trip {
  const char* world;
  std::vector<std::string> places;
};
const Trip kTrips[] = {{"four_targets", {"target_1", "target_2", "target_3", "target_4"}},
                       {"u_trap", {"goal"}},
                       {"l_corner", {"goal"}},
                       {"clutter", {"goal", "north_west", "south_east", "middle"}},
                       {"office",
                        {"door_a", "hall", "door_b", "corner_b", "door_b", "door_c", "meeting", "door_c", "hall_east",
                         "door_f", "door_e", "door_d", "kitchen"}}};

/// Whether commands act at once or a cycle later: it finds out.
TEST(ClosedLoop, ThePolarMapReachesEverythingWithoutTouching) {
  for (const Trip& trip : kTrips)
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const auto run = run_in(trip.world, trip.places, seed, "polar", static_cast<int>(seed % 2), 0.3);
      EXPECT_TRUE(run.success) << trip.world << " seed " << seed << ": " << run.reason;
      EXPECT_EQ(run.contacts, 0) << trip.world << " seed " << seed;
    }
}

TEST(ClosedLoop, ThePolarMapSaysThatItIsTrappedWhereNoWayLeads) {
  auto world = room(8, 8);
  world->add(Obstacle{.name = "", .shape = Rectangle{{4, 4}, {0.1, 8}, 0}, .surface = {}});
  Sim sim(world, {nomad(Pose2{1.5, 4, 0})}, {.seed = 3});
  const auto run = drive(sim, navigator_by_name("polar", sim.robot().platform),
                         subgoal_list({{.position = {6.5, 4}, .tolerance = 0.25, .heading = {}, .name = {}}}));
  EXPECT_FALSE(run.success);
  EXPECT_NE(run.reason.find("no progress for 15 s"), std::string::npos) << run.reason;
  EXPECT_EQ(run.contacts, 0);
}

}  // namespace
}  // namespace meander
