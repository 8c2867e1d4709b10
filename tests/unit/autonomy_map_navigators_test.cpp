// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/map_navigators.hpp"

#include <gtest/gtest.h>

#include "mapping/classic_models.hpp"
#include "polar/polar_navigator.hpp"
#include "polar_flatland.hpp"

namespace meander {
namespace {

const Platform& nomad() { return platform("nomad200"); }

std::shared_ptr<LocalMap> a_map(int size = 104) {
  LocalMapOptions options;
  options.size = size;
  return std::make_shared<LocalMap>(nomad(), cone_model(nomad().sonar), options);
}

Subgoal at(double x, double y) { return {.position = {x, y}, .tolerance = 0.25, .heading = {}, .name = {}}; }

/// Full speed ahead, whatever is there.
Navigator blind() {
  return {.name = "blind", .step = [](const Observation&, const Subgoal&) {
            return NavigatorStep{{nomad().body.v_max, 0, 0}, NavigatorStatus::driving, {}};
          }};
}

TEST(MapNavigator, DrivesAroundAWallThatTheMapShows) {
  Flatland world({{1.5, -0.8, 1.5, 0.8}, {-3, -3, 6, -3}, {-3, 3, 6, 3}});
  const Navigator navigator = polar_on_map(nomad(), a_map());
  const Subgoal goal = at(3.5, 0);
  bool arrived = false;
  for (int cycle = 0; cycle < 200 && !arrived; ++cycle)
    arrived = world.step(navigator, goal).status == NavigatorStatus::arrived;
  EXPECT_TRUE(arrived);
  EXPECT_GT(world.least_gap, 0);
  EXPECT_TRUE(polar_inside(navigator)) << "can be looked into";
}

TEST(MapNavigator, ForgetsTheMapWhenANewRunBegins) {
  const auto map = a_map();
  const Navigator navigator = polar_on_map(nomad(), map);
  Flatland world({{1, -2, 1, 2}});
  for (int cycle = 0; cycle < 3; ++cycle) world.step(navigator, at(3, 0));
  std::vector<Vec2> points;
  occupied_cells(*map, 0.5, {0, 0}, 3, points);
  EXPECT_FALSE(points.empty());
  navigator.reset();
  occupied_cells(*map, 0.5, {0, 0}, 3, points);
  EXPECT_TRUE(points.empty());
}

TEST(MapSafety, StopsARobotThatDoesNotLook) {
  for (const double y : {-0.3, 0.0, 0.17}) {
    Flatland world({{2.5, -2, 2.5 + y, 2}});
    const Navigator navigator = with_map_safety(blind(), nomad(), a_map(60));
    NavigatorStep last;
    for (int cycle = 0; cycle < 40; ++cycle) last = world.step(navigator, at(9, 0));
    EXPECT_GT(world.least_gap, 0) << y;
    EXPECT_LT(world.least_gap, 0.5) << "near, not far from it";
    EXPECT_LT(last.command.v, 0.1) << y;
    EXPECT_EQ(last.reason, "slowed down by the map");
    EXPECT_EQ(navigator.name, "blind+safety");
  }
}

TEST(MapSafety, LeavesTheCommandAloneWhereNothingIs) {
  Flatland world({});
  const Navigator navigator = with_map_safety(blind(), nomad(), a_map(60));
  for (int cycle = 0; cycle < 10; ++cycle) {
    const NavigatorStep step = world.step(navigator, at(9, 0));
    EXPECT_EQ(step.command.v, nomad().body.v_max);
    EXPECT_EQ(step.reason, "");
  }
}

TEST(MapSafety, UnusableOptionsAreErrors) {
  MapSafetyOptions safety;
  safety.margin = -1;
  EXPECT_THROW(with_map_safety(blind(), nomad(), a_map(), safety), ArgumentError);
  MapObstacleOptions obstacles;
  obstacles.occupied = 1;
  EXPECT_THROW(polar_on_map(nomad(), a_map(), {}, obstacles), ArgumentError);
}

}  // namespace
}  // namespace meander
