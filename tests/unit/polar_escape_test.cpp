// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "polar/free_ways.hpp"
#include "polar/polar_navigator.hpp"
#include "polar_flatland.hpp"

namespace meander {
namespace {

constexpr double kPeriod = 0.33;

/// What a closed-loop trip was like.
struct Trip {
  NavigatorStatus status = NavigatorStatus::driving;
  std::vector<std::string> reasons;
  double time = 0;
};

Trip drive(Flatland& land, const PolarOptions& options, const Vec2& target, double most) {
  const Navigator navigator = polar_navigator(platform("nomad200"), options);
  Trip trip;
  for (; trip.time < most && trip.status == NavigatorStatus::driving; trip.time += kPeriod) {
    const NavigatorStep step = land.step(navigator, {.position = target, .tolerance = 0.25, .heading = {}, .name = {}});
    trip.status = step.status;
    if (!step.reason.empty()) trip.reasons.push_back(step.reason);
  }
  return trip;
}

/// A U that opens to the left, larger than the scope; the robot inside.
std::vector<Flatland::Segment> large_u() { return {{-2, -3, 3, -3}, {3, -3, 3, 3}, {3, 3, -2, 3}}; }

TEST(BoundaryEscape, LeadsOutOfATrapLargerThanTheScope) {
  Flatland land(large_u());
  const Trip trip = drive(land, {}, {6, 0}, 300);
  EXPECT_EQ(trip.status, NavigatorStatus::arrived);
  EXPECT_GT(land.least_gap, 0);
  ASSERT_FALSE(trip.reasons.empty());
  EXPECT_NE(trip.reasons.front().find("no progress for 15 s"), std::string::npos) << trip.reasons.front();
  EXPECT_NE(trip.reasons.front().find("escape 1 of"), std::string::npos) << trip.reasons.front();
}

/// A hole in the wall ahead is free for the robot with 3 cm to spare and too narrow for it to go through.
TEST(BoundaryEscape, DoesNotComeBackForEverToAGapThatItWillNotPass) {
  Flatland land({{-2, -3, 3, -3}, {3, -3, 3, -0.305}, {3, 0.305, 3, 3}, {3, 3, -2, 3}});
  PolarOptions options;
  options.trap.escapes = 8;
  const Trip trip = drive(land, options, {6, 0}, 600);
  EXPECT_EQ(trip.status, NavigatorStatus::arrived);
  EXPECT_GT(land.least_gap, 0);
  EXPECT_FALSE(trip.reasons.empty());
}

TEST(BoundaryEscape, InAClosedRoomTheGuideIsToldAfterBothSides) {
  Flatland land({{-1.5, -1.5, 1.5, -1.5}, {1.5, -1.5, 1.5, 1.5}, {1.5, 1.5, -1.5, 1.5}, {-1.5, 1.5, -1.5, -1.5}});
  PolarOptions options;
  options.trap.escapes = 2;
  const Trip trip = drive(land, options, {6, 0.3}, 400);
  EXPECT_EQ(trip.status, NavigatorStatus::trapped);
  EXPECT_GT(land.least_gap, 0);
  ASSERT_GE(trip.reasons.size(), 3);
  const std::string &first = trip.reasons[trip.reasons.size() - 3], &second = trip.reasons[trip.reasons.size() - 2];
  const bool left_first = first.find("escape 1 of 2, to the left") != std::string::npos;
  EXPECT_NE(second.find(left_first ? "escape 2 of 2, to the right" : "escape 2 of 2, to the left"), std::string::npos)
      << first << '\n'
      << second;
  EXPECT_NE(trip.reasons.back().find("came round to where it has been"), std::string::npos);
  EXPECT_NE(trip.reasons.back().find("after 2 escapes"), std::string::npos) << trip.reasons.back();
}

TEST(BoundaryEscape, ThePaperHasNone) {
  Flatland land(large_u());
  PolarOptions options;
  options.mode = PolarMode::paper;
  const Trip trip = drive(land, options, {6, 0}, 60);
  EXPECT_EQ(trip.status, NavigatorStatus::driving);
  EXPECT_TRUE(trip.reasons.empty());
}

TEST(BoundaryEscape, AnotherSubgoalEndsIt) {
  Flatland land(large_u());
  const Navigator navigator = polar_navigator(platform("nomad200"));
  const auto escaping = [&] { return polar_inside(navigator)->trap().temporary().has_value(); };
  for (int i = 0; i < 300 && !escaping(); ++i)
    land.step(navigator, {.position = {6, 0}, .tolerance = 0.25, .heading = {}, .name = {}});
  EXPECT_TRUE(escaping());
  land.step(navigator, {.position = {-6, 0}, .tolerance = 0.25, .heading = {}, .name = {}});
  EXPECT_FALSE(escaping());
}

TEST(FreeWays, EndWhereTheDiscTouchesAPoint) {
  FreeWays ways(72, 2);
  ways.look({{1, 0.1}}, 0.3, 0);
  EXPECT_NEAR(ways.way(0), 1 - std::sqrt(0.3 * 0.3 - 0.1 * 0.1), 1e-12);
  EXPECT_EQ(ways.way(36), 2) << "behind";
  EXPECT_EQ(ways.way(-10), 2) << "aside";
  EXPECT_EQ(ways.nearest(0.09), 1);
  EXPECT_NEAR(ways.place(18, 0.5).y(), 0.5, 1e-12);
}

TEST(FreeWays, APointWithinTheBodyStopsOnlyWaysTowardsIt) {
  FreeWays ways(36, 2);
  ways.look({{0, 0.2}}, 0.3, 0);
  EXPECT_NEAR(ways.way(9), 0, 2e-3);
  EXPECT_EQ(ways.way(-9), 2);
}

}  // namespace
}  // namespace meander
