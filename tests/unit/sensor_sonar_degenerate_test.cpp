// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Places where exact geometry goes wrong first: on vertices and edges, along collinear walls, at nearly flat
// half-angles, among thousands of candidates, far outside everything.
#include <gtest/gtest.h>

#include "sensor_sonar_support.hpp"

namespace meander {
namespace {

using namespace oracle;

SonarOptions everything() {
  SonarOptions o = sonar_preset("real");
  o.near_field = 0.3;
  o.firing = Firing::simultaneous;
  o.crosstalk = true;
  return o;
}

void expect_in_range(const std::vector<double>& ranges, const SonarOptions& o) {
  for (const double r : ranges) {
    EXPECT_GE(r, o.range_min);
    EXPECT_LE(r, o.range_max);  // also false for NaN
  }
}

/// A world on a coarse raster: shared vertices, collinear and coincident walls, boxes side by side, door frames.
World raster_world(Stream& random) {
  World world;
  const auto at = [&] { return Vec2(0.5 * random.below(17) - 4, 0.5 * random.below(17) - 4); };
  for (int i = 0; i < 40; ++i) {
    const Vec2 a = at(), b = at();
    if (a == b) continue;
    switch (random.below(4)) {
      case 0:
        world.add(obstacle(Disc{a, 0.25 * (1 + random.below(2))}));
        break;
      case 1:
        world.add(obstacle(Rectangle{a, {0.5 * (1 + random.below(4)), 0.5 * (1 + random.below(4))}, 0}));
        break;
      default:
        world.add(obstacle(Chain{{a, b}, false}));
    }
  }
  return world;
}

TEST(SonarDegenerate, raster_worlds_from_raster_places) {
  Stream random(31, "raster");
  for (int trial = 0; trial < 60; ++trial) {
    Scene scene;
    scene.follow(raster_world(random));
    for (const double radius : {0.0, 0.25, 0.5}) {
      SonarOptions o = everything();
      if (trial % 3 == 0) o.half_cone = 1.5;
      SonarRing ring(RingLayout{.count = 16, .radius = radius, .first = 0}, o, 1);
      for (int k = 0; k < 40; ++k)
        expect_in_range(
            scan(ring, scene, {0.25 * random.below(33) - 4, 0.25 * random.below(33) - 4, kPi / 4 * random.below(8)}),
            o);
    }
  }
}

/// What stands on shared vertices does not depend on rounding: a tiny shift changes next to no reading, but for contact
/// and where it opens a slit between two vertices in one line with the transducer.
TEST(SonarDegenerate, readings_on_a_raster_survive_a_shift_of_1e_9) {
  Stream random(32, "shift");
  SonarOptions o = plain_options();
  o.incidence = true;
  o.bounce = true;
  int changed = 0, compared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Scene scene;
    scene.follow(raster_world(random));
    SonarRing ring(RingLayout{.count = 16, .radius = 0.1, .first = 0}, o, 1);
    for (int k = 0; k < 20; ++k) {
      const Pose2 pose{0.5 * random.below(17) - 3.75, 0.5 * random.below(17) - 3.75, kPi / 4 * random.below(8)};
      Pose2 moved = pose;
      moved.x += random.uniform(-1e-9, 1e-9), moved.y += random.uniform(-1e-9, 1e-9);
      const std::vector<double> a = scan(ring, scene, pose), b = scan(ring, scene, moved);
      for (int i = 0; i < 16; ++i)
        if (a[i] > 0 && b[i] > 0) changed += std::abs(a[i] - b[i]) > 0.01, ++compared;
    }
  }
  EXPECT_LT(changed, compared / 2000) << "of " << compared;
}

TEST(SonarDegenerate, on_a_vertex_on_an_edge_and_within) {
  World world;
  world.add(obstacle(Rectangle{{1, 0}, {2, 2}, 0}));
  Scene scene;
  scene.follow(world);
  const SonarOptions o = everything();
  SonarRing ring(RingLayout{.count = 16, .radius = 0, .first = 0}, o, 1);
  for (const Pose2& pose : {Pose2{0, 0, 0}, Pose2{0, 1, 0.1}, Pose2{0, -1, 3}, Pose2{1, 0, 0}})
    EXPECT_EQ(scan(ring, scene, pose), std::vector<double>(16, o.range_min));
  const std::vector<double> off = scan(ring, scene, {-1e-6, 0, 0});
  EXPECT_EQ(off[0], o.range_min);
  EXPECT_NE(off[8], o.range_min);
}

TEST(SonarDegenerate, along_a_line_of_collinear_walls) {
  World world;
  for (int i = 0; i < 5; ++i) world.add(obstacle(Chain{{{1.0 + i, 0}, {1.5 + i, 0}}, false}));
  world.add(obstacle(Chain{{{5.6, -1}, {5.6, 1}}, false}));
  Scene scene;
  scene.follow(world);
  SonarOptions o = plain_options();
  const RingLayout one{.count = 1, .radius = 0, .first = 0};
  SonarRing plain(one, o, 1);
  EXPECT_NEAR(scan(plain, scene, {0, 0, 0})[0], 1, 1e-12);
  o.incidence = true;
  SonarRing incidence(one, o, 1);
  EXPECT_NEAR(scan(incidence, scene, {0, 0, 0})[0], 5.6, 1e-9);
  o.bounce = true;
  SonarRing bounce(one, o, 1);
  EXPECT_NEAR(scan(bounce, scene, {0, 1e-12, 0})[0], 5.6, 1e-9);
}

TEST(SonarDegenerate, far_from_everything_and_far_from_the_origin) {
  World world;
  world.add(obstacle(Rectangle{{0, 0}, {1, 1}, 0}));
  world.add(obstacle(Rectangle{{9e5 + 3, 9e5}, {2, 2}, 0}));
  Scene scene;
  scene.follow(world);
  const SonarOptions o = plain_options();
  SonarRing ring(RingLayout{.count = 1, .radius = 0.2, .first = 0}, o, 1);
  EXPECT_EQ(scan(ring, scene, {-5000, 7000, 1})[0], o.range_max);
  EXPECT_NEAR(scan(ring, scene, {9e5, 9e5, 0})[0], 1.8, 1e-8);
  EXPECT_NEAR(scan(ring, scene, {-3, 0, 0})[0], 2.3, 1e-12);
}

TEST(SonarDegenerate, walls_far_longer_than_the_range_and_huge_discs) {
  World world;
  world.add(obstacle(Chain{{{3, -5e4}, {3, 5e4}}, false}));
  world.add(obstacle(Disc{{-2e4 - 2, 0}, 2e4}));
  Scene scene;
  scene.follow(world);
  SonarRing ring(RingLayout{.count = 2, .radius = 0, .first = 0}, plain_options(), 1);
  const std::vector<double> ranges = scan(ring, scene, {0, 0, 0.01});
  EXPECT_NEAR(ranges[0], 3, 1e-9);
  EXPECT_NEAR(ranges[1], 2, 1e-9);
}

TEST(SonarDegenerate, thousands_of_candidates_in_one_cone) {
  Stream random(33, "crowd");
  World world;
  for (int i = 0; i < 1500; ++i)
    world.add(obstacle(Rectangle{{random.uniform(1, 6), random.uniform(-3, 3)}, {0.02, 0.02}, random.uniform(-3, 3)}));
  for (int i = 0; i < 500; ++i) world.add(obstacle(Disc{{random.uniform(1, 6), random.uniform(-3, 3)}, 0.01}));
  Scene scene;
  scene.follow(world);
  SonarOptions o = plain_options();
  o.incidence = true;
  o.incidence_limit = 0.001;  // next to nothing answers, so that everything is looked at
  o.half_cone = 0.6;
  const RingLayout one{.count = 1, .radius = 0, .first = 0};
  const Pieces pieces = pieces_of(scene);
  for (const bool bounce : {false, true}) {
    o.bounce = bounce;
    SonarRing ring(one, o, 1);
    expect_in_range(scan(ring, scene, {0, 0, 0}), o);
    if (!bounce) {
      EXPECT_LE(scan(ring, scene, {0, 0, 0})[0], bundle(pieces, look({}, one, 0), o, 2001) + 1e-9);
    }
  }
}

}  // namespace
}  // namespace meander
