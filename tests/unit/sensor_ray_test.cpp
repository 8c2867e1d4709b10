// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/ray.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace meander {
namespace {

constexpr std::uint32_t kNobody = ~0u;

Scene cluttered(Stream& random) {
  World world;
  for (int i = 0; i < 8; ++i)
    world.add(Obstacle{.name = {},
                       .shape = Rectangle{{random.uniform(1, 9), random.uniform(1, 9)}, {0.5, 1}, random.uniform(0, 3)},
                       .surface = {}});
  Scene scene;
  scene.follow(world);
  for (std::uint32_t i = 0; i < 5; ++i)
    scene.moving.push_back({.disc = {{random.uniform(0, 10), random.uniform(0, 10)}, random.uniform(0.1, 0.5)},
                            .owner = Scene::kMovingOwner + i});
  return scene;
}

/// First distance at which a point moving along the ray is in something, by small steps.
double march(const Scene& scene, const Vec2& origin, const Vec2& direction, double max_range, std::uint32_t self) {
  for (double range = 0; range < max_range; range += 1e-3) {
    const Vec2 p = origin + range * direction;
    if (scene.walls().inside(p)) return range;
    for (const Pole& pole : scene.moving)
      if (pole.owner != self && (p - pole.disc.center).norm() <= pole.disc.radius) return range;
  }
  return max_range;
}

TEST(Ray, StopsAtTheFirstThingStandingOrMoving) {
  int moving = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Stream random(seed, "rays");
    const Scene scene = cluttered(random);
    for (int i = 0; i < 40; ++i) {
      const Vec2 p(random.uniform(0, 10), random.uniform(0, 10));
      const std::uint32_t self = random.chance(0.5) ? kNobody : Scene::kMovingOwner + 2;
      if (march(scene, p, {1, 0}, 1e-3, self) == 0) continue;
      const SinCos t = sin_cos(random.uniform(-4, 4));
      const auto hit = cast_ray(scene, p, {t.cos, t.sin}, 6, self);
      const double range = hit ? hit->range : 6, marched = march(scene, p, {t.cos, t.sin}, 6, self);
      if (marched > range + 2e-3)
        EXPECT_LE(scene.walls().distance(hit->point, 1), 1e-9) << "only a corner may be stepped over";
      else
        EXPECT_NEAR(marched, range, 2e-3);
      moving += hit && hit->owner >= Scene::kMovingOwner;
    }
  }
  EXPECT_GT(moving, 50);
}

TEST(Ray, AFanIsItsRays) {
  Stream random(1, "fan");
  const Scene scene = cluttered(random);
  const Pose2 pose{5, 5, 0.7};
  std::vector<double> bearings, ranges(90);
  for (int i = 0; i < 90; ++i) bearings.push_back(radians(4.0 * i));
  cast_fan(scene, pose, bearings, 4, kNobody, ranges);
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const Vec2 u = Pose2{0, 0, pose.heading + bearings[i]}.direction();
    const auto hit = cast_ray(scene, pose.position(), u, 4, kNobody);
    EXPECT_EQ(ranges[i], hit ? hit->range : 4);
  }
  EXPECT_THROW(cast_fan(scene, pose, bearings, 4, kNobody, std::span(ranges).first(3)), ArgumentError);
}

TEST(Ray, OwnDiscIsNotSeen) {
  Scene scene;
  scene.moving.push_back({.disc = {{0, 0}, 0.3}, .owner = Scene::kMovingOwner});
  scene.moving.push_back({.disc = {{2, 0}, 0.5}, .owner = Scene::kMovingOwner + 1});
  EXPECT_DOUBLE_EQ(cast_ray(scene, {0, 0}, {1, 0}, 9, Scene::kMovingOwner)->range, 1.5);
  EXPECT_DOUBLE_EQ(cast_ray(scene, {0, 0}, {1, 0}, 9, kNobody)->range, 0.3);
}

}  // namespace
}  // namespace meander
