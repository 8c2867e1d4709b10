// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "polar/dynamic_window.hpp"
#include "polar/polar_navigator.hpp"
#include "polar/potential_field.hpp"
#include "polar/tangent_bug.hpp"
#include "polar/vfh_plus.hpp"
#include "polar_flatland.hpp"

namespace meander {
namespace {

/// What making a navigator with these options complains about.
std::string complaint(const PolarOptions& options, const Platform& robot = platform("nomad200")) {
  try {
    polar_navigator(robot, options);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return {};
}

bool names(const std::string& text, std::initializer_list<const char*> words) {
  for (const char* word : words)
    if (text.find(word) == std::string::npos) return false;
  return true;
}

TEST(PolarLimits, ScopesWithinTheRobotAreRefused) {
  PolarOptions options;
  options.map.layout.scope = 0.25;
  options.map.layout.rings = options.map.layout.sectors = 8;
  EXPECT_TRUE(names(complaint(options), {"map.scope", "0.25", "0.2667"})) << complaint(options);
  Platform giant = platform("nomad200");
  giant.body.radius = 3;
  EXPECT_TRUE(names(complaint({}, giant), {"map.scope", "2.54", "at least"}));
}

TEST(PolarLimits, PaperModeRefusesWhatItWouldPassOver) {
  PolarOptions options;
  options.mode = PolarMode::paper;
  options.memory.contradictions = 3;
  EXPECT_EQ(complaint(options), "option 'memory.contradictions': 0 in mode 'paper' expected, got 3");
  options.memory.contradictions = 0;
  EXPECT_EQ(complaint(options), "");
  options.control.soft_margin = 0.35;
  EXPECT_EQ(complaint(options), "option 'control.soft_margin': 0.2 in mode 'paper' expected, got 0.35");
  options.control = {};
  options.subgoal.hysteresis = 1;
  EXPECT_TRUE(names(complaint(options), {"subgoal.hysteresis", "paper"}));
  options.mode = PolarMode::full;
  EXPECT_EQ(complaint(options), "");
}

TEST(PolarLimits, TheLeastScopeDrivesAgainstAWall) {
  PolarOptions options;
  options.control.hard_margin = options.control.soft_margin = options.map.margin = options.map.narrow_margin = 0;
  options.map.layout.rings = options.map.layout.sectors = 8;
  options.map.layout.scope = 0.2667 + 0.051;
  options.map.merge = 0.001;
  options.memory.scans = 100;
  options.memory.contradictions = 0;
  options.prediction.latency = 3;
  options.trap.watch = false;
  options.subgoal.read_radius = 0.1;
  const Navigator navigator = polar_navigator(platform("nomad200"), options);
  Flatland plane({{1.5, -3, 1.5, 3}});
  for (int k = 0; k < 150; ++k) plane.step(navigator, {.position = {4, 0.3}, .heading = {}, .name = {}});
  for (const MappedPoint& point : polar_inside(navigator)->points())
    EXPECT_LE(point.position.norm(), options.map.layout.scope);
}

TEST(PolarLimits, DecaysThatNoNumberHoldsAreRefused) {
  for (const auto& [scope, kappa] : std::vector<std::pair<double, double>>{{30, 30}, {60, 20}, {10, 200}}) {
    PolarOptions options;
    options.map.layout.scope = scope;
    options.map.layout.rings = 512;
    options.map.kappa = kappa;
    EXPECT_TRUE(names(complaint(options), {"map.kappa", "map.scope"})) << complaint(options);
  }
  PolarOptions wide;
  wide.map.layout.scope = 10;
  wide.map.layout.rings = 512;
  EXPECT_EQ(complaint(wide), "");
}

TEST(PolarLimits, RingsThatHardlyGrowAreRefused) {
  PolarOptions options;
  options.map.layout.radii = PolarRadii::log;
  options.map.layout.innermost = std::nextafter(2.54, 0);
  EXPECT_TRUE(names(complaint(options), {"map.innermost", "2.54", "apart"})) << complaint(options);
  options.map.layout.innermost = 3;
  EXPECT_TRUE(names(complaint(options), {"map.innermost", "less than map.scope"})) << complaint(options);
}

TEST(PolarLimits, OptionsThatContradictEachOtherAreRefused) {
  const auto with = [](auto change) {
    PolarOptions options;
    change(options);
    return complaint(options);
  };
  EXPECT_EQ(with([](PolarOptions& o) { o.memory.range_min = o.memory.range_max = 3; }),
            "option 'memory.range_min': less than memory.range_max = 3 m expected, got 3");
  EXPECT_EQ(with([](PolarOptions& o) { o.control.hard_margin = 0.5; }),
            "option 'control.hard_margin': at most control.soft_margin = 0.3 m expected, got 0.5");
  EXPECT_EQ(with([](PolarOptions& o) { o.map.narrow_margin = 0.06; }),
            "option 'map.narrow_margin': at most map.margin = 0.05 m expected, got 0.06");
  EXPECT_EQ(with([](PolarOptions& o) { o.subgoal.read_radius = 3; }),
            "option 'subgoal.read_radius': at most map.scope = 2.54 m expected, got 3");
}

TEST(PolarLimits, RobotsWithoutSonarsAreRefused) {
  Platform deaf = platform("nomad200");
  deaf.name = "deaf";
  deaf.sonar.count = 0;
  EXPECT_EQ(complaint({}, deaf), "navigator 'polar' needs sonars; robot 'deaf' has none");
  EXPECT_THROW(potential_field(deaf), ArgumentError);
  EXPECT_THROW(vfh_plus(deaf), ArgumentError);
  EXPECT_THROW(dynamic_window(deaf), ArgumentError);
  EXPECT_THROW(tangent_bug(deaf), ArgumentError);
}

TEST(Projection, MarksBothEndsOfAWaySectorPlacedUnevenly) {
  const PolarLayoutOptions options{.rings = 20, .sectors = 8, .layout = PolarPlacing::self_organising};
  PolarLayout layout(options);
  // Seven sectors within half a radian, the rest of the turn between two of them.
  std::vector<double> bearings;
  for (int k = 0; k < 8; ++k) bearings.push_back(k < 4 ? 0.07 * k : 2 * kPi - 0.07 * (8 - k));
  layout.place(layout.radii(), bearings);
  for (int turn = 0; turn < 64; ++turn) {
    const SinCos t = sin_cos(2 * kPi * turn / 64);
    const Vec2 point = 0.6 * Vec2(t.cos, t.sin);
    Projection projection(layout, {0.599});
    projection.add(point);
    for (int sector = 0; sector < 8; ++sector)
      for (int ring = 1; ring < 19; ++ring)
        EXPECT_EQ(projection.layer(0).test(ring, sector), (layout.position(ring, sector) - point).norm() <= 0.599)
            << turn << " " << ring << " " << sector;
  }
}

TEST(PointMapper, APointPushedBeyondTheScopeIsLeftOut) {
  for (const double scope : {0.2, 0.2667, 0.27, 0.3}) {
    PointMapper mapper(0.2667, scope, 0.001, 1000);
    std::vector<Vec2> points;
    for (int k = 0; k < 1000; ++k) {
      const SinCos t = sin_cos(2 * kPi * k / 1000);
      points.push_back(0.15 * Vec2(t.cos, t.sin));
    }
    mapper.map(points, {0, 0, 0.3}, {5, 5});
    EXPECT_EQ(mapper.points().empty(), scope < 0.2717);
    for (const MappedPoint& point : mapper.points()) EXPECT_LE(point.position.norm(), scope);
  }
}

}  // namespace
}  // namespace meander
