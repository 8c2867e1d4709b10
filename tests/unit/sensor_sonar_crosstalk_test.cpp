// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "sensor_sonar_support.hpp"

namespace meander {
namespace {

using namespace oracle;

/// Half the shortest way from one transducer over one wall to another, by enumeration of all walls.
double shortest_way(const Pieces& pieces, const Look& sender, const Look& hearer, const SonarOptions& o) {
  double best = o.range_max;
  for (const Wall& wall : pieces.walls) {
    const Vec2 d = (wall.b - wall.a).normalized(), n(-d.y(), d.x());
    const double from = n.dot(sender.origin - wall.a), to = n.dot(hearer.origin - wall.a);
    if (from * to <= 0) continue;
    const Vec2 image = sender.origin - 2 * from * n;
    const Vec2 p = image + (hearer.origin - image) * from / (from + to);
    const double place = d.dot(p - wall.a);
    if (place < 0 || place > (wall.b - wall.a).norm()) continue;
    if (std::abs(angle_to(sender, p)) > o.half_cone || std::abs(angle_to(hearer, p)) > o.receive_lobe) continue;
    const double range = 0.5 * ((p - sender.origin).norm() + (p - hearer.origin).norm());
    if (range < best && free_between(pieces, sender.origin, p) && free_between(pieces, hearer.origin, p)) best = range;
  }
  return best;
}

SonarOptions crosstalk_options() {
  SonarOptions o = plain_options();
  o.incidence = true;
  o.incidence_limit = radians(20);
  return o;
}

TEST(SonarCrosstalk, agrees_with_an_enumeration_of_all_walls) {
  Stream random(9, "crosstalk");
  int decided = 0;
  for (int trial = 0; trial < 120; ++trial) {
    SonarOptions options = crosstalk_options();
    SonarRing alone(RingLayout{}, options, 1);
    options.crosstalk = true;
    SonarRing ring(RingLayout{}, options, 1);
    const World world = clutter(random, 20, 5, 0.5);
    Scene scene;
    scene.follow(world);
    const Pieces pieces = pieces_of(scene);
    const Pose2 pose{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-3, 3)};
    const std::vector<double> ranges = scan(ring, scene, pose), own = scan(alone, scene, pose);
    for (int i = 0; i < 16; ++i) {
      double expected = own[i];
      for (int k = 0; k < 16; ++k)
        if (k != i)
          expected = std::min(
              expected, shortest_way(pieces, look(pose, ring.layout(), k), look(pose, ring.layout(), i), options));
      EXPECT_NEAR(ranges[i], expected, 1e-9) << "trial " << trial << " transducer " << i;
      decided += expected < own[i];
    }
  }
  EXPECT_GT(decided, 50);
}

int changed_by_crosstalk(SonarOptions options) {
  SonarRing alone(RingLayout{}, options, 1);
  options.crosstalk = true;
  SonarRing ring(RingLayout{}, options, 1);
  Stream random(10, "schedule");
  int changed = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const World world = clutter(random, 20, 5, 0.5);
    Scene scene;
    scene.follow(world);
    const Pose2 pose{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-3, 3)};
    const std::vector<double> ranges = scan(ring, scene, pose), own = scan(alone, scene, pose);
    for (int i = 0; i < 16; ++i) changed += ranges[i] < own[i] - 0.01;
  }
  return changed;
}

TEST(SonarCrosstalk, needs_transducers_that_fire_together_and_hear_wide) {
  SonarOptions options = crosstalk_options();
  EXPECT_GT(changed_by_crosstalk(options), 20);
  SonarOptions sharp = options;
  sharp.receive_lobe = sharp.half_cone;
  EXPECT_LT(changed_by_crosstalk(sharp), changed_by_crosstalk(options) / 4);
  options.firing = Firing::sequence;
  EXPECT_EQ(changed_by_crosstalk(options), 0);
  options.fired_together = 4;  // every fourth
  EXPECT_EQ(changed_by_crosstalk(options), 0);
}

}  // namespace
}  // namespace meander
