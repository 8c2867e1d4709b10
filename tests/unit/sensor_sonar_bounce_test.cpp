// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "sensor_sonar_support.hpp"

namespace meander {
namespace {

using namespace oracle;

constexpr int kRays = 8001;

Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// The first echo of one ray: direct, or after one reflection at a wall that did not answer.
double ray_with_bounce(const Pieces& pieces, const Look& look, double angle, const SonarOptions& o) {
  const Vec2 u = unit(angle);
  const Hit first = cast(pieces, look.origin, u);
  if (answers(o, first.range, first.incidence)) return first.range;
  if (first.wall < 0 || first.range > o.range_max) return kNone;
  const Wall& wall = pieces.walls[first.wall];
  const Vec2 d = (wall.b - wall.a).normalized(), p = look.origin + first.range * u;
  const Vec2 v = 2 * d.dot(u) * d - u;
  const Hit second = cast(pieces, p, v, 1e-7);
  const double whole = first.range + second.range;
  return answers(o, whole, second.incidence) ? whole : kNone;
}

double bundle_with_bounce(const Pieces& pieces, const Look& look, const SonarOptions& o, int rays) {
  double best = o.range_max;
  for (int i = 0; i < rays; ++i)
    best = std::min(best, ray_with_bounce(pieces, look, look.axis + o.half_cone * (2.0 * i / (rays - 1) - 1), o));
  return best;
}

TEST(SonarBounce, agrees_with_dense_mirrored_rays) {
  SonarOptions options = plain_options();
  options.incidence = true;
  options.bounce = true;
  SonarOptions direct = options;
  direct.bounce = false;
  Stream random(5, "bounce");
  int slivers = 0, decided = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const World world = clutter(random, 25, 5, 0.5);
    Scene scene;
    scene.follow(world);
    SonarRing ring(RingLayout{}, options, 1), without(RingLayout{}, direct, 1);
    const Pieces pieces = pieces_of(scene);
    const Pose2 pose{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-3, 3)};
    const std::vector<double> ranges = scan(ring, scene, pose), direct_ranges = scan(without, scene, pose);
    for (int i = 0; i < 16; ++i) {
      const Look from = look(pose, ring.layout(), i);
      const double rays = bundle_with_bounce(pieces, from, options, kRays);
      EXPECT_LE(ranges[i], rays + 1e-9) << "trial " << trial << " transducer " << i;
      EXPECT_LE(ranges[i], direct_ranges[i]);
      decided += ranges[i] < direct_ranges[i];
      if (ranges[i] > rays - 5e-3) continue;
      ++slivers;
      EXPECT_GE(ranges[i], bundle_with_bounce(pieces, from, options, 40 * kRays) - 5e-3)
          << "trial " << trial << " transducer " << i << " rays " << rays;
    }
  }
  EXPECT_GT(decided, 8);
  EXPECT_LE(slivers, 4);
}

/// The nearest convex corner seen over one wall: every wall, every corner, the way by the mirror image.
double nearest_mirrored_corner(const Pieces& pieces, const Look& look, const SonarOptions& o) {
  double best = o.range_max;
  for (const Wall& mirror : pieces.walls) {
    const Vec2 d = (mirror.b - mirror.a).normalized(), n(-d.y(), d.x());
    const double depth = n.dot(look.origin - mirror.a);
    for (const Wall& wall : pieces.walls)
      for (const auto& [corner, convex] : {std::pair{wall.a, wall.convex_a}, std::pair{wall.b, wall.convex_b}}) {
        const double corner_depth = n.dot(corner - mirror.a);
        if (!convex || depth * corner_depth <= 0 || std::abs(corner_depth) < 1e-6) continue;
        const Vec2 image = corner - 2 * corner_depth * n;
        const double range = (image - look.origin).norm();
        if (range > o.corner_range || range >= best || std::abs(angle_to(look, image)) > o.half_cone) continue;
        const Vec2 p = look.origin + (image - look.origin) * depth / (depth + corner_depth);
        const double place = d.dot(p - mirror.a);
        if (place < 0 || place > (mirror.b - mirror.a).norm()) continue;
        if (free_between(pieces, look.origin, p) && free_between(pieces, p, corner)) best = range;
      }
  }
  return best;
}

TEST(SonarBounce, corners_in_the_mirror_answer_as_an_enumeration_says) {
  SonarOptions options = plain_options();
  options.incidence = true;
  options.incidence_limit = radians(2);
  options.corner_range = 4;
  options.bounce = true;
  SonarOptions without = options;
  without.corner_range = 0;
  Stream random(6, "mirrored corners");
  int decided = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const World world = clutter(random, 20, 4, 0.4);
    Scene scene;
    scene.follow(world);
    SonarRing with(RingLayout{}, options, 1), faces(RingLayout{}, without, 1);
    const Pieces pieces = pieces_of(scene);
    const Pose2 pose{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-3, 3)};
    const std::vector<double> ranges = scan(with, scene, pose), face_ranges = scan(faces, scene, pose);
    for (int i = 0; i < 16; ++i) {
      const Look from = look(pose, with.layout(), i);
      const double seen = std::min(nearest_corner(pieces, from, options), face_ranges[i]);
      const double mirrored = nearest_mirrored_corner(pieces, from, options);
      EXPECT_NEAR(ranges[i], std::min(seen, mirrored), 1e-7) << "trial " << trial << " transducer " << i;
      decided += mirrored < seen;
    }
  }
  EXPECT_GT(decided, 30);
}

TEST(SonarBounce, reads_the_wall_behind_over_a_slanted_mirror) {
  World world;  // a mirror at 45 degrees ahead of the robot, a wall to its left that the mirror shows
  world.add(obstacle(Chain{{{1, -1}, {3, 1}}, false}));
  world.add(obstacle(Chain{{{0, 3}, {5, 3}}, false}));
  Scene scene;
  scene.follow(world);
  SonarOptions options = plain_options();
  options.incidence = true;
  options.incidence_limit = radians(20);
  const RingLayout one{.count = 1, .radius = 0, .first = 0};
  SonarRing without(one, options, 1);
  EXPECT_EQ(scan(without, scene, {0, 0, 0})[0], options.range_max);
  options.bounce = true;
  SonarRing with(one, options, 1);
  EXPECT_NEAR(scan(with, scene, {0, 0, 0})[0], 2 + 3, 1e-12);
}

}  // namespace
}  // namespace meander
