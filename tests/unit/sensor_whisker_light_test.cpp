// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "robot/platform.hpp"
#include "sensor/light.hpp"
#include "sensor/whisker.hpp"
#include "world/world.hpp"

namespace meander {
namespace {

constexpr WhiskerOptions kSure{.reach = 0.15, .false_alarm = 0, .miss = 0};
constexpr LightSensorOptions kQuiet{.lobe = radians(25), .contrast = 100, .noise = 0};
constexpr std::uint32_t kNobody = 7;

Scene scene_with(std::vector<Item> items) {
  World world;
  for (Item& item : items) world.add(std::move(item));
  Scene scene;
  scene.follow(world);
  return scene;
}

Item wall(const Vec2& a, const Vec2& b) { return Obstacle{"", Chain{{a, b}}, {}}; }

TEST(Whiskers, AWallBendsTheArcThatReachesIt) {
  // A wall 0.2 m ahead: rods of 0.3 m in all reach it up to acos(2/3) = 48 degrees to both sides.
  const Scene scene = scene_with({wall({0.2, -3}, {0.2, 3})});
  std::vector<std::uint8_t> bent(24);
  for (const double heading : {0.0, kPi / 2, -2.0}) {
    WhiskerRing(platform("alice").whisker, kSure, 1).read(scene, {0, 0, heading}, kNobody, bent);
    for (int i = 0; i < 24; ++i) {
      const double off = std::abs(wrap_angle(heading + i * kPi / 12));
      EXPECT_EQ(bent[static_cast<std::size_t>(i)], off < std::acos(2.0 / 3)) << heading << " " << i;
    }
  }
}

TEST(Whiskers, TellFalseContactsAndMissTrueOnesAsOftenAsAsked) {
  const Scene scene = scene_with({wall({0.2, -3}, {0.2, 3})});
  WhiskerRing ring(platform("alice").whisker, {.reach = 0.15, .false_alarm = 0.01, .miss = 0.02}, 5);
  std::vector<std::uint8_t> bent(24);
  int misses = 0, alarms = 0;
  constexpr int kScans = 20000;
  for (int scan = 0; scan < kScans; ++scan) {
    ring.read(scene, {0, 0, 0}, kNobody, bent);
    misses += !bent[0];
    alarms += bent[12];
  }
  EXPECT_NEAR(misses, 0.02 * kScans, 5 * std::sqrt(0.02 * kScans));
  EXPECT_NEAR(alarms, 0.01 * kScans, 5 * std::sqrt(0.01 * kScans));
}

TEST(Lights, TheSensorThatFacesTheLampIsBrightest) {
  const Scene scene = scene_with({Light{"lamp", {0, 2}, 1}});
  std::vector<double> light(24);
  LightRing(platform("alice").light, kQuiet, 1).read(scene, {0, 0, 0}, kNobody, light);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_LE(light[i], light[6]);  // 6 * 15 degrees: to the left
  const double brightness = 1 / (1 + 1.85 * 1.85);
  EXPECT_NEAR(light[6], std::log(1 + 100 * brightness) / std::log(101), 1e-12);
  EXPECT_NEAR(light[4], light[8], 1e-12);
}

TEST(Lights, WallsThrowShadowsAndEditsMoveLamps) {
  World world;
  const Id lamp = world.add(Light{"lamp", {3, 0}, 1});
  const Id screen = world.add(Obstacle{"", Chain{{{1, -1}, {1, 1}}}, {}});
  Scene scene;
  LightRing ring(platform("alice").light, kQuiet, 1);
  std::vector<double> light(24);
  const auto ahead = [&] {
    scene.follow(world);
    ring.read(scene, {0, 0, 0}, kNobody, light);
    return light[0];
  };
  EXPECT_EQ(ahead(), 0);
  world.remove(screen);
  const double bright = ahead();
  EXPECT_GT(bright, 0.3);
  world.remove(lamp);
  EXPECT_EQ(ahead(), 0);
  world.undo();
  EXPECT_EQ(ahead(), bright);
}

TEST(Lights, ALampUnderTheSensorIsDefined) {
  const Scene scene = scene_with({Light{"lamp", {0.15, 0}, 2}});
  std::vector<double> light(24);
  LightRing(platform("alice").light, kQuiet, 1).read(scene, {0, 0, 0}, kNobody, light);
  for (const double reading : light) EXPECT_TRUE(std::isfinite(reading));
  EXPECT_NEAR(light[0], std::log(201) / std::log(101), 1e-12);
}

}  // namespace
}  // namespace meander
