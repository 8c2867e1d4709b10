// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/bumper.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "geometry/segment.hpp"

namespace meander {
namespace {

constexpr std::uint32_t kNobody = ~0u;
constexpr double kReach = 0.01;

std::vector<std::uint8_t> read(const Scene& scene, const RingLayout& layout, const Pose2& pose,
                               std::uint32_t self = kNobody) {
  std::vector<std::uint8_t> pressed(static_cast<std::size_t>(layout.count), 9);
  read_bumpers(scene, layout, kReach, pose, self, pressed);
  return pressed;
}

std::string text(const std::vector<std::uint8_t>& pressed) {
  std::string text;
  for (const std::uint8_t p : pressed) text += p ? '#' : '.';
  return text;
}

Scene scene_of(const std::vector<Shape>& shapes) {
  World world(Header{.title = {}, .note = {}, .bounds = {{-50, -50}, {50, 50}}, .start = {}});
  for (const Shape& shape : shapes) world.add(Obstacle{.name = {}, .shape = shape, .surface = {}});
  Scene scene;
  scene.follow(world);
  return scene;
}

TEST(Bumper, PressesWhereItTouches) {
  const RingLayout ring{8, 0.3, 0};
  const Scene wall = scene_of({Chain{{{0.305, -5}, {0.305, 5}}, false}});
  EXPECT_EQ(text(read(wall, ring, {0, 0, 0})), "#.......");
  EXPECT_EQ(text(read(wall, ring, {0, 0, kPi / 2})), "......#.");
  EXPECT_EQ(text(read(wall, ring, {-0.1, 0, 0})), "........");
  EXPECT_EQ(text(read(wall, {8, 0.3, kPi / 2}, {0, 0, 0})), "......#.");
  const Scene corridor = scene_of({Chain{{{-5, 0.3}, {5, 0.3}}, false}, Chain{{{-5, -0.3}, {5, -0.3}}, false}});
  EXPECT_EQ(text(read(corridor, ring, {0, 0, 0})), "..#...#.");
}

TEST(Bumper, MovingDiscsPressButNotTheOwn) {
  Scene scene;
  scene.moving.push_back({.disc = {{0, 0}, 0.3}, .owner = Scene::kMovingOwner});
  scene.moving.push_back({.disc = {{0, 0.6}, 0.3}, .owner = Scene::kMovingOwner + 1});
  EXPECT_EQ(text(read(scene, {8, 0.3, 0}, {0, 0, 0}, Scene::kMovingOwner)), "..#.....");
  EXPECT_EQ(text(read(scene, {8, 0.3, 0}, {0, 0, 0})), "########") << "inside a disc";
}

TEST(Bumper, AgreesWithTheBearingsOfManySurfacePoints) {
  int pressed_count = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Stream random(seed, "bumpers");
    const RingLayout ring{1 + random.below(24), random.uniform(0.1, 0.5), random.uniform(-3, 3)};
    const Pose2 pose{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-3, 3)};
    const Vec2 at = pose.position();
    const auto near = [&](double least) {
      const SinCos t = sin_cos(random.uniform(-4, 4));
      return Vec2(at + (ring.radius + random.uniform(least, 0.5)) * Vec2(t.cos, t.sin));
    };
    const Vec2 a = near(-0.05), b = near(-0.05), c = near(0.05);
    const Disc disc{c, random.uniform(0.2, 1) * (c - at).norm()};
    const Scene scene = scene_of({Chain{{a, b}, false}, disc});
    std::vector<std::uint8_t> surely(static_cast<std::size_t>(ring.count)), perhaps = surely;
    const auto touch = [&](const Vec2& p) {
      const double distance = (p - at).norm() - ring.radius - kReach;
      if (distance > 1e-9) return;
      const double share = 2 * kPi / ring.count;
      const double place = (angle_of((p - at).y(), (p - at).x()) - pose.heading - ring.first) / share + 0.5;
      for (const double slip : {-1e-6, 0.0, 1e-6}) {
        const double wrapped = place + slip - ring.count * std::floor((place + slip) / ring.count);
        const auto i = static_cast<std::size_t>(std::min<double>(wrapped, ring.count - 1));
        perhaps[i] = 1;
        if (slip == 0 && distance < -1e-9) surely[i] = 1;
      }
    };
    for (int i = 0; i <= 4000; ++i) touch(a + i / 4000.0 * (b - a));
    for (int i = 0; i < 200; ++i)
      for (int k = 0; k <= 50; ++k) {
        const SinCos t = sin_cos(2 * kPi * i / 200);
        touch(disc.center + disc.radius * k / 50 * Vec2(t.cos, t.sin));
      }
    const std::vector<std::uint8_t> pressed = read(scene, ring, pose);
    int missed = 0;
    for (std::size_t i = 0; i < pressed.size(); ++i) {
      EXPECT_TRUE(pressed[i] || !surely[i]) << seed << ": bumper " << i << " should be pressed";
      missed += pressed[i] && !perhaps[i];
      pressed_count += pressed[i];
    }
    EXPECT_LE(missed, 2) << seed << ": only the last sliver at an end may lie between two points";
  }
  EXPECT_GT(pressed_count, 300);
}

TEST(Bumper, RoomForEveryBumperIsNeeded) {
  std::vector<std::uint8_t> pressed(3);
  EXPECT_THROW(read_bumpers(Scene{}, {8, 0.3, 0}, kReach, {}, kNobody, pressed), ArgumentError);
  EXPECT_TRUE(read(Scene{}, {0, 0.3, 0}, {}).empty());
}

}  // namespace
}  // namespace meander
