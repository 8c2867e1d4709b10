// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "sensor_sonar_support.hpp"

namespace meander {
std::size_t allocations();  // allocation_counter.cpp

namespace {

using namespace oracle;

SonarOptions everything() {
  SonarOptions o = sonar_preset("real");
  o.near_field = 0.3;
  o.firing = Firing::simultaneous;
  o.crosstalk = true;
  return o;
}

/// A wandering robot: small steps, turns, all within a hall of clutter.
std::vector<Pose2> wander(Stream& random, int steps) {
  std::vector<Pose2> path;
  Pose2 pose;
  for (int i = 0; i < steps; ++i) {
    pose.heading = wrap_angle(pose.heading + random.uniform(-0.3, 0.3) + (std::hypot(pose.x, pose.y) > 2 ? 0.5 : 0));
    pose.x += 0.1 * std::cos(pose.heading);
    pose.y += 0.1 * std::sin(pose.heading);
    path.push_back(pose);
  }
  return path;
}

TEST(SonarRing, a_kept_candidate_list_reads_the_same_bits_as_one_gathered_anew) {
  Stream random(21, "cache");
  for (int trial = 0; trial < 6; ++trial) {
    const World world = clutter(random, 120, 9, 0.4);
    Scene scene;
    scene.follow(world);
    SonarRing kept(RingLayout{}, everything(), 4), anew(RingLayout{}, everything(), 4);
    for (const Pose2& pose : wander(random, 120)) {
      const Scene copy = scene;  // a copy is another index: nothing gathered from the original serves
      const std::vector<double> a = scan(kept, scene, pose), b = scan(anew, copy, pose);
      ASSERT_EQ(a, b) << "trial " << trial;
    }
  }
}

TEST(SonarRing, edits_are_seen_at_once) {
  World world;
  Scene scene;
  SonarRing ring(RingLayout{.count = 1, .radius = 0, .first = 0}, plain_options(), 1);
  scene.follow(world);
  EXPECT_EQ(scan(ring, scene, {})[0], ring.options().range_max);
  const Id id = world.add(obstacle(Disc{{2, 0}, 0.5}));
  scene.follow(world);
  EXPECT_NEAR(scan(ring, scene, {})[0], 1.5, 1e-12);
  world.add(obstacle(Disc{{100, 0}, 0.5}));
  scene.follow(world);
  EXPECT_NEAR(scan(ring, scene, {})[0], 1.5, 1e-12);
  world.remove(id);
  scene.follow(world);
  EXPECT_EQ(scan(ring, scene, {})[0], ring.options().range_max);
}

TEST(SonarRing, a_copy_goes_on_like_the_original) {
  Stream random(22, "fork");
  const World world = clutter(random, 60, 7, 0.4);
  Scene scene;
  scene.follow(world);
  SonarRing ring(RingLayout{}, everything(), 4);
  const std::vector<Pose2> path = wander(random, 40);
  for (int i = 0; i < 20; ++i) scan(ring, scene, path[i]);
  SonarRing copy = ring;
  Hash a, b;
  for (int i = 20; i < 40; ++i) ASSERT_EQ(scan(ring, scene, path[i]), scan(copy, scene, path[i]));
  ring.add_to(a), copy.add_to(b);
  EXPECT_EQ(a.hex(), b.hex());
  scan(ring, scene, {});
  Hash c;
  ring.add_to(c);
  EXPECT_NE(a.hex(), c.hex());
}

/// The same in every build: pins the bits of the whole model.
TEST(SonarRing, checksum_of_many_scans) {
  Stream random(23, "checksum");
  Hash hash;
  for (int trial = 0; trial < 4; ++trial) {
    const World world = clutter(random, 80, 7, 0.4);
    Scene scene;
    scene.follow(world);
    SonarRing ring(RingLayout{}, everything(), 4);
    Stream steps(trial, "steps");
    double heading = 0;
    for (int i = 0; i < 50; ++i) {
      heading = wrap_angle(heading + steps.uniform(-0.5, 0.5));
      for (const double r : scan(ring, scene, {0.02 * i, -0.01 * i, heading})) hash.add(r);
    }
  }
  EXPECT_EQ(hash.hex(), "42b21a08dc963437");
}

TEST(SonarRing, scans_without_allocating) {
  Stream random(24, "allocations");
  const World world = clutter(random, 120, 7, 0.4);
  Scene scene;
  scene.follow(world);
  scene.moving.assign(20, Pole{Disc{{2, 1}, 0.2}, Scene::kMovingOwner, 0});
  SonarRing ring(RingLayout{}, everything(), 4);
  const std::vector<Pose2> path = wander(random, 300);
  std::vector<double> ranges(16);
  std::vector<Pose2> poses(16);
  for (int round = 0; round < 3; ++round) {  // where the list is gathered settles in the second round
    const std::size_t before = allocations();
    for (const Pose2& pose : path) {
      std::fill(poses.begin(), poses.end(), pose);
      ring.scan(scene, poses, SonarRing::kNobody, ranges);
    }
    if (round == 2) {
      EXPECT_EQ(allocations() - before, 0u);
    }
  }
}

TEST(SonarRing, fires_one_after_the_other_or_in_groups_or_at_once) {
  SonarOptions o;
  const auto times = [&](const SonarOptions& options) {
    const SonarRing ring(RingLayout{}, options, 1);
    return std::vector<double>(ring.firing_times().begin(), ring.firing_times().end());
  };
  EXPECT_EQ(times(o).front(), 1 / 16.0);
  EXPECT_EQ(times(o).back(), 1);
  o.fired_together = 4;  // 0, 4, 8, 12 first
  EXPECT_EQ(times(o)[0], 0.25);
  EXPECT_EQ(times(o)[4], 0.25);
  EXPECT_EQ(times(o)[3], 1);
  o.firing = Firing::simultaneous;
  EXPECT_EQ(times(o), std::vector<double>(16, 1.0));
}

TEST(SonarRing, every_transducer_listens_where_the_robot_is_when_it_fires) {
  World world;
  world.add(obstacle(Chain{{{3, -9}, {3, 9}}, false}));
  Scene scene;
  scene.follow(world);
  SonarRing ring(RingLayout{.count = 2, .radius = 0.2, .first = 0}, plain_options(), 1);
  std::vector<double> ranges(2);
  const std::vector<Pose2> poses{{0, 0, 0}, {1, 0, kPi}};
  ring.scan(scene, poses, SonarRing::kNobody, ranges);
  EXPECT_NEAR(ranges[0], 2.8, 1e-12);
  EXPECT_NEAR(ranges[1], 1.8, 1e-12);
  EXPECT_THROW(ring.scan(scene, std::span(poses).first(1), SonarRing::kNobody, ranges), ArgumentError);
}

TEST(SonarRing, contact_reads_the_minimum) {
  World world;
  world.add(obstacle(Rectangle{{1, 0}, {1, 2}, 0}));           // solid from x = 0.5 on
  world.add(obstacle(Chain{{{-0.1, -2}, {-0.1, 2}}, false}));  // thin, within the ring
  world.add(obstacle(Disc{{0, 0.4}, 0.2}));                    // touches the ring
  Scene scene;
  scene.follow(world);
  SonarOptions o = plain_options();
  o.range_min = 0.1;
  SonarRing ring(RingLayout{.count = 4, .radius = 0.2, .first = 0}, o, 1);
  std::vector<double> ranges = scan(ring, scene, {0, 0, 0});
  EXPECT_NEAR(ranges[0], 0.3, 1e-12);
  EXPECT_EQ(ranges[1], 0.1) << "touches a disc";
  EXPECT_EQ(ranges[2], 0.1) << "a thin wall stands between it and the centre";
  EXPECT_GT(ranges[3], 0.1);
  ranges = scan(ring, scene, {0.4, 0, 0});
  EXPECT_EQ(ranges[0], 0.1) << "within a solid";
  EXPECT_EQ(scan(ring, scene, {1, 0, 0}), std::vector<double>(4, 0.1)) << "all of it in a solid";
  EXPECT_EQ(scan(ring, scene, {0.3, 0, 0})[0], 0.1) << "touches a wall";
}

TEST(SonarRing, a_ring_without_transducers_reads_nothing) {
  SonarRing ring(RingLayout{.count = 0, .radius = 0.2, .first = 0}, {}, 1);
  EXPECT_TRUE(scan(ring, Scene{}, {}).empty());
}

}  // namespace
}  // namespace meander
