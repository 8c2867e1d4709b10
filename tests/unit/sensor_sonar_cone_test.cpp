// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "sensor_sonar_support.hpp"

namespace meander {
namespace {

using namespace oracle;

constexpr int kRays = 4001;

/// Compares readings with dense bundles in random clutter. A sliver narrower than a ray's step escapes the bundle:
/// where it is later, it is asked again by ten times as many rays.
void compare_with_bundles(const SonarOptions& options, const char* name) {
  Stream random(7, name);
  int compared = 0, slivers = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const World world = clutter(random, 60, 7, 0.6);
    Scene scene;
    scene.follow(world);
    SonarRing ring(RingLayout{}, options, 1);
    const Pieces pieces = pieces_of(scene);
    for (int k = 0; k < 2; ++k) {
      const Pose2 pose{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-3, 3)};
      const std::vector<double> ranges = scan(ring, scene, pose);
      for (int i = 0; i < 16; ++i) {
        const Look from = look(pose, ring.layout(), i);
        const double rays = bundle(pieces, from, options, kRays);
        EXPECT_LE(ranges[i], rays + 1e-9) << name << " trial " << trial << " transducer " << i;
        if (ranges[i] < rays - 2e-3) {
          ++slivers;
          EXPECT_GE(ranges[i], bundle(pieces, from, options, 40 * kRays) - 2e-3)
              << name << " trial " << trial << " transducer " << i << " rays " << rays;
        }
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 256);
  EXPECT_LE(slivers, 4) << name;
}

TEST(SonarCone, is_never_later_than_a_dense_bundle_and_within_2_mm) { compare_with_bundles(plain_options(), "plain"); }

TEST(SonarCone, with_incidence_rule_is_never_later_than_a_dense_bundle_and_within_2_mm) {
  SonarOptions options = plain_options();
  options.incidence = true;
  for (const double limit : {10, 30, 60}) {
    options.incidence_limit = radians(limit);
    compare_with_bundles(options, "incidence");
  }
}

TEST(SonarCone, with_near_field_is_never_later_than_a_dense_bundle_and_within_2_mm) {
  SonarOptions options = plain_options();
  options.incidence = true;
  options.near_field = 1.0;
  compare_with_bundles(options, "near field");
}

TEST(SonarCone, wide_cones_are_exact_too) {
  SonarOptions options = plain_options();
  options.incidence = true;
  options.half_cone = 1.5;
  compare_with_bundles(options, "wide");
}

TEST(SonarCone, corners_answer_as_an_enumeration_of_all_corners_says) {
  SonarOptions options = plain_options();
  options.incidence = true;
  options.incidence_limit = radians(15);
  options.corner_range = 2.5;
  SonarOptions without = options;
  without.corner_range = 0;
  Stream random(11, "corners");
  int decided = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const World world = clutter(random, 40, 5, 0.4);
    Scene scene;
    scene.follow(world);
    SonarRing with(RingLayout{}, options, 1), faces(RingLayout{}, without, 1);
    const Pieces pieces = pieces_of(scene);
    const Pose2 pose{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-3, 3)};
    const std::vector<double> ranges = scan(with, scene, pose), face_ranges = scan(faces, scene, pose);
    for (int i = 0; i < 16; ++i) {
      const double corner = nearest_corner(pieces, look(pose, with.layout(), i), options);
      EXPECT_NEAR(ranges[i], std::min(corner, face_ranges[i]), 1e-9) << "trial " << trial << " transducer " << i;
      decided += corner < face_ranges[i];
    }
  }
  EXPECT_GT(decided, 300);
}

TEST(SonarCone, misses_no_pole_whose_axis_is_in_the_cone) {
  for (const bool incidence : {false, true}) {
    SonarOptions options = plain_options();
    options.incidence = incidence;
    SonarRing ring(RingLayout{.count = 1, .radius = 0, .first = 0}, options, 1);
    Stream random(3, "poles");
    Scene scene;
    for (int i = 0; i < 20000; ++i) {
      const double range = random.uniform(0.2, 6), angle = random.uniform(-0.999, 0.999) * options.half_cone;
      const double radius = random.uniform(0.01, 0.05);
      scene.moving = {Pole{Disc{{range * std::cos(angle), range * std::sin(angle)}, radius}, Scene::kMovingOwner, 0}};
      ASSERT_NEAR(scan(ring, scene, {0, 0, 0})[0], range - radius, 1e-12) << i;
    }
  }
}

}  // namespace
}  // namespace meander
