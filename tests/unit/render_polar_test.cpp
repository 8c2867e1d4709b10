// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "render/draw_polar.hpp"

namespace meander {
namespace {

const RobotLook kLook{.radius = 0.2667, .ring = platform("nomad200").sonar, .half_cone = 0.22, .range_max = 6.477};

Observation seeing(double ahead) {
  Observation observation;
  observation.period = 0.33;
  observation.readings.sonar.assign(16, 6.477);
  for (const std::size_t i : {15, 0, 1}) observation.readings.sonar[i] = ahead;
  observation.readings.sonar_pose.assign(16, Pose2{});
  return observation;
}

DrawList picture(double target) {
  PolarNavigator navigator(platform("nomad200"), {});
  navigator.step(seeing(0.8), {.position = {target, 0}, .tolerance = 0.1, .heading = {}, .name = {}});
  return draw_polar(navigator, kLook);
}

template <class Item>
const Item* first(const DrawList& list, Mark mark) {
  for (const DrawItem& item : list.items)
    if (const Item* found = std::get_if<Item>(&item); found && mark_of(item) == mark) return found;
  return nullptr;
}

TEST(DrawPolar, ShowsObstructedUnitsEchoesAndTheWayRoundThem) {
  const DrawList list = picture(5);
  EXPECT_TRUE(std::all_of(list.items.begin(), list.items.end(), drawable));
  const auto* units = first<DrawCells>(list, Mark::cell);
  ASSERT_TRUE(units);
  EXPECT_GT(std::count(units->marks.begin(), units->marks.end(), Mark::wall), 100);
  EXPECT_TRUE(first<DrawPolyline>(list, Mark::echo));
  const auto* way = first<DrawPolyline>(list, Mark::path);
  ASSERT_TRUE(way);
  double aside = 0;
  for (const Vec2& point : way->points) aside = std::max(aside, std::abs(point.y()));
  EXPECT_GT(aside, 0.3) << "straight on there is a wall";
  EXPECT_NEAR(way->points.back().x(), 2.54, 1e-9) << "the target lies beyond the scope";
}

TEST(DrawPolar, ATargetWithinTheScopeIsWhereItIs) {
  const DrawList list = picture(2);
  const auto* target = first<DrawDisc>(list, Mark::goal);
  ASSERT_TRUE(target);
  EXPECT_NEAR(target->disc.center.x(), 2, 0.02);
}

TEST(DrawPolar, NothingToDrawBeforeTheFirstStep) {
  EXPECT_THROW(draw_polar(PolarNavigator(platform("nomad200"), {}), kLook), ArgumentError);
}

}  // namespace
}  // namespace meander
