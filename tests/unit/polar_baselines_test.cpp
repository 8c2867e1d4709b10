// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Laws that hold for every baseline: potential field, VFH+, dynamic window, TangentBug.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "polar/dynamic_window.hpp"
#include "polar/near_points.hpp"
#include "polar/polar_navigator.hpp"
#include "polar/potential_field.hpp"
#include "polar/tangent_bug.hpp"
#include "polar/vfh_plus.hpp"
#include "polar_flatland.hpp"

namespace meander {
namespace {

struct Baseline {
  const char* name;
  Navigator (*make)(const Platform&);
};
constexpr Baseline kBaselines[] = {
    {"vfh_plus", [](const Platform& p) { return vfh_plus(p); }},
    {"dynamic_window", [](const Platform& p) { return dynamic_window(p); }},
    {"tangent_bug", [](const Platform& p) { return tangent_bug(p); }},
};

class BaselineTest : public testing::TestWithParam<Baseline> {
 protected:
  Navigator make() const { return GetParam().make(platform("nomad200")); }
};

Subgoal at(const Vec2& position, double tolerance = 0.15) {
  return {.position = position, .tolerance = tolerance, .heading = {}, .name = {}};
}

TEST_P(BaselineTest, NeverExceedsTheLimitsOfTheBody) {
  const Body body = platform("nomad200").body;
  Stream random(3, "baselines");
  const Navigator navigator = make();
  Observation seen = Flatland({}).observation({}, 0, 0);
  for (int i = 0; i < 500; ++i) {
    for (double& range : seen.readings.sonar) range = random.uniform(0.152, random.chance(0.5) ? 1.0 : 6.477);
    seen.time += 0.33;
    seen.odometry.v = random.uniform(0, body.v_max);
    seen.odometry.w = random.uniform(-body.w_max, body.w_max);
    const Command c = navigator.step(seen, at({random.uniform(-3, 3), random.uniform(-3, 3)})).command;
    ASSERT_GE(c.v, 0);
    ASSERT_LE(c.v, body.v_max + 1e-12);
    ASSERT_LE(std::abs(c.w), body.w_max + 1e-12);
  }
}

TEST_P(BaselineTest, StopsBeforeAWall) {
  for (const double gap : {1.5, 0.8}) {
    Flatland land({{2, -20, 2, 20}});
    land.pose = {2 - 0.2667 - gap, 0, 0};
    const Navigator navigator = make();
    for (int i = 0; i < 200; ++i) land.step(navigator, at({8, 0}));
    EXPECT_GT(land.least_gap, 0) << gap;
  }
}

TEST_P(BaselineTest, ReachesInTheOpenFromAnywhere) {
  Stream random(8, "poses");
  for (int i = 0; i < 40; ++i) {
    Flatland land({});
    land.pose = {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-kPi, kPi)};
    const Navigator navigator = make();
    NavigatorStep last;
    for (int k = 0; k < 250 && last.status == NavigatorStatus::driving; ++k) last = land.step(navigator, at({0, 0}));
    EXPECT_EQ(last.status, NavigatorStatus::arrived) << i;
  }
}

TEST_P(BaselineTest, AMirroredSituationGivesTheMirroredCommand) {
  Stream random(5, "mirror");
  for (int i = 0; i < 60; ++i) {
    Observation one = Flatland({}).observation({}, random.uniform(0, 0.3), random.uniform(-0.3, 0.3)), other = one;
    for (std::size_t k = 0; k < 16; ++k) {
      one.readings.sonar[k] = random.chance(0.5) ? random.uniform(0.4, 2.5) : 6.477;
      other.readings.sonar[(16 - k) % 16] = one.readings.sonar[k];
    }
    other.odometry.w = -one.odometry.w;
    const Vec2 goal(random.uniform(-3, 3), random.uniform(-3, 3));
    const Command a = make().step(one, at(goal)).command, b = make().step(other, at({goal.x(), -goal.y()})).command;
    EXPECT_NEAR(a.v, b.v, 1e-9) << i;
    EXPECT_NEAR(a.w, -b.w, 1e-9) << i;
  }
}

TEST_P(BaselineTest, ArrivesAndTurnsToTheHeadingAskedFor) {
  const Navigator navigator = make();
  Subgoal goal = at({0.1, 0});
  const Observation seen = Flatland({}).observation({}, 0, 0);
  EXPECT_EQ(navigator.step(seen, goal).status, NavigatorStatus::arrived);
  goal.heading = -1.5;
  const NavigatorStep turning = navigator.step(seen, goal);
  EXPECT_EQ(turning.status, NavigatorStatus::driving);
  EXPECT_LT(turning.command.w, 0);
}

TEST_P(BaselineTest, SaysThatItIsTrapped) {
  Flatland land({{1, -1, 1, 1}, {-1, -1, -1, 1}, {-1, 1, 1, 1}, {-1, -1, 1, -1}});
  const Navigator navigator = make();
  int reports = 0;
  for (int i = 0; i < 400; ++i) {
    const NavigatorStep step = land.step(navigator, at({5, 0}));
    reports += step.status == NavigatorStatus::trapped;
    EXPECT_EQ(step.reason.empty(), step.status != NavigatorStatus::trapped);
  }
  EXPECT_GE(reports, 1);
  EXPECT_GT(land.least_gap, 0);
}

TEST_P(BaselineTest, ResetForgets) {
  Flatland land({{1.5, -1, 1.5, 1}}), fresh = land;
  const Navigator navigator = make();
  for (int i = 0; i < 30; ++i) land.step(navigator, at({4, 0}));
  navigator.reset();
  const Observation seen = fresh.observation({}, 0, 0);
  EXPECT_EQ(navigator.step(seen, at({4, 1})).command, make().step(seen, at({4, 1})).command);
}

INSTANTIATE_TEST_SUITE_P(All, BaselineTest, testing::ValuesIn(kBaselines),
                         [](const auto& baseline) { return baseline.param.name; });

constexpr Baseline kNavigators[] = {
    {"polar", [](const Platform& p) { return polar_navigator(p); }},
    {"potential_field", [](const Platform& p) { return potential_field(p); }},
    kBaselines[0],
    kBaselines[1],
    kBaselines[2],
};

/// What may happen at the edges is the same for all.
class EdgeCaseTest : public BaselineTest {
 protected:
  static constexpr double kLeast = 0.152, kMost = 6.477;
  /// Drives on by made-up readings; every answer is one that the body can follow.
  NavigatorStep drive(const Observation& first, const Subgoal& goal, int cycles = 60) const {
    const Body body = platform("nomad200").body;
    const Navigator navigator = make();
    Observation seen = first;
    NavigatorStep step;
    for (int i = 0; i < cycles; ++i) {
      step = navigator.step(seen, goal);
      EXPECT_TRUE(step.command.v >= 0 && step.command.v <= body.v_max + 1e-12) << i << ": " << step.command.v;
      EXPECT_LE(std::abs(step.command.w), body.w_max + 1e-12) << i;
      EXPECT_TRUE(step.status != NavigatorStatus::trapped || !step.reason.empty()) << i;
      seen.time += 0.33;
    }
    return step;
  }
  static Observation reading(double range) {
    Observation seen = Flatland({}).observation({}, 0, 0);
    std::fill(seen.readings.sonar.begin(), seen.readings.sonar.end(), range);
    return seen;
  }
};

TEST_P(EdgeCaseTest, ASubgoalOnTheRobotIsReachedAndOneWithinItsBodyIsNotYet) {
  EXPECT_EQ(drive(reading(kMost), at({0, 0}, 0.02)).status, NavigatorStatus::arrived);
  EXPECT_EQ(drive(reading(kMost), at({0.01, 0}, 0.02)).status, NavigatorStatus::arrived);
  const NavigatorStep first = drive(reading(kMost), at({0.12, 0}, 0.02), 1);
  EXPECT_EQ(first.status, NavigatorStatus::driving);
  EXPECT_NE(first.command, Command{});
}

TEST_P(EdgeCaseTest, ASubgoalBehindMakesItTurn) {
  for (const Vec2& behind : {Vec2(-2, 0), Vec2(-0.2, 0), Vec2(-9, 1e-12)}) {
    const NavigatorStep first = drive(reading(kMost), at(behind, 0.02), 1);
    EXPECT_GT(std::abs(first.command.w), 0.01) << behind.x();
  }
}

TEST_P(EdgeCaseTest, ReachesWhatIsBehindOrWithinItsBody) {
  for (const Vec2& goal : {Vec2(-2, 0), Vec2(0.15, 0.1), Vec2(-0.2, 0)}) {
    Flatland land({});
    const Navigator navigator = make();
    NavigatorStep last;
    for (int k = 0; k < 250 && last.status == NavigatorStatus::driving; ++k)
      last = land.step(navigator, at(goal, 0.03));
    EXPECT_EQ(last.status, NavigatorStatus::arrived) << goal.x();
  }
}

TEST_P(EdgeCaseTest, AllReadingsAtMaximumAreFreeGround) {
  EXPECT_GT(drive(reading(kMost), at({5, 0}), 1).command.v, 0.05);
}

/// Everything may touch; what reads the minimum is taken to be 4 cm off the hull, and no farther may it creep.
TEST_P(EdgeCaseTest, AllReadingsAtMinimumStopIt) {
  EXPECT_LE(0.33 * drive(reading(kLeast), at({5, 0}), 1).command.v, 0.04);
  drive(reading(kLeast), at({5, 0}));
  drive(reading(kLeast), at({0.1, 0}, 0.02));
}

/// A robot without sonars drives blind; what it is told to, it does.
TEST_P(EdgeCaseTest, NoReadingsAtAll) {
  Observation blind = reading(kMost);
  blind.readings.sonar.clear();
  blind.readings.sonar_pose.clear();
  EXPECT_GT(drive(blind, at({5, 0}), 1).command.v, 0.05);
  drive(blind, at({-1, 0}));
}

/// A wall at the hull on the left: away from it along the front is allowed, into it is not.
TEST_P(EdgeCaseTest, StartsInContact) {
  Flatland land({{-3, 0.2767, 3, 0.2767}});
  const Navigator navigator = make();
  double least = 1;
  NavigatorStep last;
  for (int k = 0; k < 300 && last.status == NavigatorStatus::driving; ++k) {
    last = land.step(navigator, at({1.5, -1.5}));
    least = std::min(least, land.least_gap);
  }
  EXPECT_EQ(last.status, NavigatorStatus::arrived);
  EXPECT_GT(least, -0.005);
}

INSTANTIATE_TEST_SUITE_P(All, EdgeCaseTest, testing::ValuesIn(kNavigators),
                         [](const auto& navigator) { return navigator.param.name; });

TEST(Baselines, SteeringSeesWhatTheHistogramDoesNot) {
  Platform fast = platform("nomad200");
  fast.body.v_max = 2;
  const Navigator navigator = vfh_plus(fast, {.window = 0.5});
  Observation seen = Flatland({{1.3, -2, 1.3, 2}}).observation({}, 0, 0);
  seen.odometry.v = 1;
  EXPECT_LT(navigator.step(seen, at({5, 0})).command.v, 1.2);
}

TEST(FreeArc, StraightAndCurvedAgreeWithSmallSteps) {
  Stream random(9, "arcs");
  for (int i = 0; i < 300; ++i) {
    const Vec2 point(random.uniform(-2, 2), random.uniform(-2, 2));
    const double radius = random.uniform(0.1, 0.4), curvature = i % 5 ? random.uniform(-3, 3) : 0;
    if (point.norm() < radius + 0.01) continue;
    const double most = std::min(2.0, curvature == 0 ? 2.0 : 2 * kPi / std::abs(curvature));
    double expected = most;
    for (double way = 0; way < most; way += 0.001) {
      const double turn = curvature * way;
      const Vec2 at = curvature == 0 ? Vec2(way, 0) : Vec2(std::sin(turn), 1 - std::cos(turn)) / curvature;
      if ((at - point).norm() >= radius) continue;
      expected = way;
      break;
    }
    EXPECT_NEAR(free_arc({point}, curvature, radius, most), expected, 0.01 + 0.05 * expected) << i;
  }
}

TEST(FreeArc, WhatIsTouchedStopsOnlyMotionThatLeadsNearer) {
  EXPECT_LT(free_arc({{0.2, 0}}, 0, 0.3, 2), 0.01);
  EXPECT_EQ(free_arc({{-0.2, 0}}, 0, 0.3, 2), 2);
  EXPECT_EQ(free_arc({}, 1, 0.3, 2), 2);
}

TEST(Baselines, OptionsAreChecked) {
  const Platform nomad = platform("nomad200");
  EXPECT_THROW(vfh_plus(nomad, {.sectors = 1}), ArgumentError);
  EXPECT_THROW(dynamic_window(nomad, {.turns = 0}), ArgumentError);
  EXPECT_THROW(tangent_bug(nomad, {.reach = std::nan("")}), ArgumentError);
}

}  // namespace
}  // namespace meander
