// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "polar/polar_navigator.hpp"
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
