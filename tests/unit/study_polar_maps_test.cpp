// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Maps as they come up while driving, held against the shortest way over the same grid.
#include <gtest/gtest.h>

#include "autonomy/subgoal_list.hpp"
#include "polar/polar_navigator.hpp"
#include "polar_support.hpp"
#include "sim_worlds.hpp"
#include "study/drive.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

/// Does the direction chosen begin a shortest way to the target's unit, to within a sector?
bool along_the_shortest_way(const PolarNavigator& polar) {
  const PolarLayout& layout = polar.layout();
  const std::vector<double> ways = geodesics(layout, polar.obstructed(), polar.target_ring());
  const int ring = std::clamp(layout.nearest_ring(polar.options().subgoal.read_radius), 1, polar.target_ring());
  const auto way = [&](int s) { return ways[static_cast<std::size_t>(layout.wrapped(s) * layout.rings() + ring)]; };
  double shortest = 1e9, chosen = 1e9;
  for (int s = 0; s < layout.sectors(); ++s) shortest = std::min(shortest, way(s));
  for (int s = -1; s <= 1; ++s) chosen = std::min(chosen, way(polar.subgoal()->sector + s));
  return chosen <= shortest * (1 + 1e-9);
}

TEST(PolarMaps, PointAlongTheShortestWayInNineOfTenThatComeUp) {
  struct Trip {
    const char* world;
    std::vector<const char*> places;
  };
  const Trip trips[] = {{"clutter", {"goal", "north_west"}},
                        {"office", {"door_a", "hall", "door_b"}},
                        {"u_trap", {"goal"}},
                        {"four_targets", {"target_1", "target_2"}}};
  int maps = 0, agree = 0;
  for (const Trip& trip : trips)
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      auto world =
          std::make_shared<World>(read_world(std::string(MEANDER_SOURCE_DIR) + "/worlds/" + trip.world + ".toml"));
      std::vector<Subgoal> goals;
      for (const char* name : trip.places) {
        const Place& place = std::get<Place>(world->item(world->find(name)));
        goals.push_back({.position = place.position, .tolerance = 0.25, .heading = {}, .name = name});
      }
      Sim sim(world, {nomad()}, {.seed = seed});
      PolarOptions options;
      options.subgoal.hysteresis = 0;  // the map's own choice
      const Navigator navigator = polar_navigator(sim.robot().platform, options);
      int cycle = 0;
      drive(sim, navigator, subgoal_list(goals), {.time_limit = 60, .record_every = 0}, {}, [&](const Sim&) {
        const auto polar = polar_inside(navigator);
        if (++cycle % 5 != 0 || !polar->subgoal()) return true;
        ++maps;
        agree += along_the_shortest_way(*polar);
        return true;
      });
    }
  EXPECT_GT(maps, 200);
  EXPECT_GE(agree, 0.9 * maps) << agree << " of " << maps;
  RecordProperty("maps", maps);
  RecordProperty("agree", agree);
}

}  // namespace
}  // namespace meander
