// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/planned_route.hpp"

#include <gtest/gtest.h>

#include "autonomy/unmapped_obstacles.hpp"

namespace meander {
namespace {

/// Two rooms of 4 m x 4 m side by side with two doors of 1 m between them.
std::shared_ptr<PlanningMap> two_rooms() {
  auto map = std::make_shared<PlanningMap>();
  map->solid = Grid<std::uint8_t>(80, 40, 0, {0.1, {}});
  set_solid(*map, {{3.9, 0}, {4.1, 4}}, true);
  set_solid(*map, {{3.9, 0.5}, {4.1, 1.5}}, false);
  set_solid(*map, {{3.9, 2.5}, {4.1, 3.5}}, false);
  return map;
}

struct Walk {
  std::vector<Vec2> points;
  GuideStep end;
};

/// A robot that goes straight to each subgoal in steps of 10 cm, until the guide has finished. `say` is its navigator.
Walk walk(const Guide& guide, Vec2 at, const std::function<NavigatorStep(const Vec2&, int)>& say) {
  Walk walk;
  NavigatorStep step;
  for (int i = 0; i < 2000; ++i) {
    Observation observation;
    observation.odometry.pose = {at.x(), at.y(), 0};
    walk.points.push_back(at);
    walk.end = guide.next(observation, step);
    if (!walk.end.subgoal) break;
    step = say(at, i);
    if (step.status == NavigatorStatus::trapped) continue;
    const Vec2 way = walk.end.subgoal->position - at;
    at += way * std::min(1.0, 0.1 / std::max(way.norm(), 1e-9));
  }
  return walk;
}
NavigatorStep drives(const Vec2&, int) { return {}; }

bool through_upper(const Walk& walk) {
  return std::any_of(walk.points.begin(), walk.points.end(),
                     [](const Vec2& p) { return std::abs(p.x() - 4) < 0.1 && p.y() > 2; });
}

TEST(PlannedRoute, LeadsThroughTheNearerDoorAndKeepsClear) {
  const auto map = two_rooms();
  const Walk way = walk(planned_route(map, {{7, 3}}, {.robot_radius = 0.25}), {1, 3}, drives);
  EXPECT_TRUE(way.end.success) << way.end.reason;
  EXPECT_EQ(way.end.reason, "target reached");
  EXPECT_TRUE(through_upper(way));
  const Clearance clearance(map->solid);
  for (std::size_t i = 1; i < way.points.size(); ++i)
    EXPECT_GE(clearance.of(way.points[i - 1] / 0.1, way.points[i] / 0.1), 2.5 - 1e-6);
}

TEST(PlannedRoute, TakesTheOtherDoorWhenTheNavigatorIsTrapped) {
  const Guide guide = planned_route(two_rooms(), {{7, 3}}, {.robot_radius = 0.25});
  const auto blocked = [](const Vec2& at, int) -> NavigatorStep {
    const bool trapped = at.x() > 3.3 && at.x() < 3.9 && at.y() > 2;
    return {.command = {}, .status = trapped ? NavigatorStatus::trapped : NavigatorStatus::driving, .reason = {}};
  };
  // The trap says nothing any more once the new path leads elsewhere: the robot leaves by itself.
  int words = 0;
  const Walk way = walk(guide, {1, 3}, [&](const Vec2& at, int i) {
    NavigatorStep step = blocked(at, i);
    if (step.status == NavigatorStatus::trapped && ++words > 3) step.status = NavigatorStatus::driving;
    return step;
  });
  EXPECT_TRUE(way.end.success) << way.end.reason;
  EXPECT_FALSE(through_upper(way));
}

TEST(PlannedRoute, PlansAnewWhenTheMapWasEdited) {
  const auto map = two_rooms();
  const Guide guide = planned_route(map, {{7, 3}}, {.robot_radius = 0.25});
  const Walk way = walk(guide, {1, 3}, [&](const Vec2&, int i) {
    if (i == 5) set_solid(*map, {{3.9, 2.5}, {4.1, 3.5}}, true);
    return NavigatorStep{};
  });
  EXPECT_TRUE(way.end.success) << way.end.reason;
  EXPECT_FALSE(through_upper(way));
}

TEST(PlannedRoute, EndsWithTheReasonWhenThereIsNoWay) {
  const auto map = two_rooms();
  const Guide guide = planned_route(map, {{7, 3}}, {.robot_radius = 0.25});
  const Walk way = walk(guide, {1, 3}, [&](const Vec2&, int i) {
    if (i == 5) set_solid(*map, {{3.9, 0}, {4.1, 4}}, true);
    return NavigatorStep{};
  });
  EXPECT_FALSE(way.end.success);
  EXPECT_NE(way.end.reason.find("no path: the start in cell"), std::string::npos) << way.end.reason;
  EXPECT_NE(way.end.reason.find("is cut off"), std::string::npos) << way.end.reason;
}

TEST(PlannedRoute, GivesUpAfterSoManyTraps) {
  const Guide guide = planned_route(two_rooms(), {{7, 3}}, {.robot_radius = 0.25, .replans = 2});
  const Walk way = walk(guide, {1, 3}, [](const Vec2&, int) -> NavigatorStep {
    return {.command = {}, .status = NavigatorStatus::trapped, .reason = "walls all round"};
  });
  EXPECT_FALSE(way.end.success);
  EXPECT_FALSE(way.end.reason.empty());
}

/// Faces along x; the sonar ahead hears something at x = 3.9 where the upper door is, the others hear nothing.
Observation before_the_upper_door(const Vec2& at) {
  Observation observation;
  observation.odometry.pose = {at.x(), at.y(), 0};
  observation.readings.sonar.assign(16, 6.477);
  observation.readings.sonar_pose.assign(16, observation.odometry.pose);
  if (std::abs(at.y() - 3) < 0.5 && at.x() < 3.4) observation.readings.sonar[0] = 3.9 - at.x() - 0.23;
  return observation;
}

TEST(PlannedRoute, GoesRoundWhatTheSonarsHear) {
  for (const bool listens : {true, false}) {
    const std::optional<Platform> robot = listens ? std::optional(platform("nomad200")) : std::nullopt;
    const Guide guide = planned_route(two_rooms(), {{7, 3}}, {.robot_radius = 0.25, .mapped = 0.1}, robot);
    Vec2 at(1, 3);
    bool upper = false;
    for (int i = 0; i < 2000; ++i) {
      Observation seen = before_the_upper_door(at);
      seen.time = 0.1 * i;
      const GuideStep step = guide.next(seen, {});
      EXPECT_TRUE(step.subgoal || step.success) << step.reason;
      if (!step.subgoal) break;
      const Vec2 way = step.subgoal->position - at;
      at += way * std::min(1.0, 0.05 / std::max(way.norm(), 1e-9));
      upper = upper || (at.x() > 3.5 && at.x() < 4.5 && at.y() > 2);
    }
    EXPECT_LT((at - Vec2(7, 3)).norm(), 0.3);
    EXPECT_EQ(upper, !listens);
  }
}

TEST(UnmappedObstacles, AreWhatIsHeardAndNotInTheMap) {
  const auto map = two_rooms();
  set_solid(*map, {{3.9, 0}, {4.1, 4}}, false);
  UnmappedObstacles unmapped(platform("nomad200"), map, 0.2);
  for (double x = 1; x < 3; x += 0.05) unmapped.listen(before_the_upper_door({x, 3}));
  EXPECT_FALSE(unmapped.points().empty());
  for (const Vec2& point : unmapped.points()) EXPECT_NEAR(point.x(), 3.9, 0.15);
  EXPECT_TRUE(unmapped.beside({3, 3}, {5, 3}, 0.25));
  EXPECT_FALSE(unmapped.beside({3, 1}, {5, 1}, 0.25));
  set_solid(*map, {{3.8, 2}, {4, 4}}, true);
  EXPECT_TRUE(unmapped.points().empty());
  set_solid(*map, {{3.8, 2}, {4, 4}}, false);
  EXPECT_FALSE(unmapped.points().empty());
  unmapped.forget();
  EXPECT_TRUE(unmapped.points().empty());
}

TEST(PlannedRoute, MisuseIsAnError) {
  EXPECT_THROW(planned_route(two_rooms(), {}), ArgumentError);
  EXPECT_THROW(planned_route(two_rooms(), {{1, 1}}, {.reach = -1}), ArgumentError);
}

TEST(PlanningMaps, UnknownCellsAreWhatOneSays) {
  Grid<float> probability(4, 1, 0);
  probability.cells() = {0.1F, 0.5F, 0.9F, std::nanf("")};
  const PlanningMap blocked = map_from_occupancy(probability);
  EXPECT_EQ(blocked.solid.cells(), (std::vector<std::uint8_t>{0, 1, 1, 1}));
  const PlanningMap free = map_from_occupancy(probability, {.unknown = UnknownCells::free});
  EXPECT_EQ(free.solid.cells(), (std::vector<std::uint8_t>{0, 0, 1, 0}));
  const PlanningMap costly = map_from_occupancy(probability, {.unknown = UnknownCells::costly, .unknown_cost = 7});
  EXPECT_EQ(costly.solid.cells(), (std::vector<std::uint8_t>{0, 0, 1, 0}));
  EXPECT_EQ(costly.difficulty.cells(), (std::vector<float>{1, 7, 1, 7}));
  EXPECT_THROW(map_from_occupancy(probability, {.occupied = 0.4, .vacant = 0.6}), ArgumentError);
}

TEST(PlanningMaps, HexagonsKeepClearOfSquares) {
  PlanningMap map{.solid = Grid<std::uint8_t>(30, 20)};
  set_solid(map, {{10, 0}, {12, 12}}, true);
  for (const double radius : {0.0, 0.8, 1.7}) {
    const Plan plan = make_plan(
        problem_on(map,
                   {.start = Vec2(3, 5), .targets = {{25, 4}}, .robot_radius = radius, .lattice = Lattice::hexagonal}),
        "neural_map", {}, PathKind::steepest);
    EXPECT_EQ(plan.reason(), "");
    EXPECT_TRUE(plan.clear) << radius << " " << plan.measures.clearance_min;
  }
}

TEST(PlannedRoute, APlanIsStoppedWhenAsked) {
  StopToken stop;
  const Guide guide = planned_route(two_rooms(), {{7, 3}}, {.robot_radius = 0.25}, std::nullopt, &stop);
  stop.request();
  EXPECT_THROW(walk(guide, {1, 3}, drives), Cancelled);
  stop.clear();
  EXPECT_TRUE(walk(guide, {1, 3}, drives).end.success);
}

}  // namespace
}  // namespace meander
