// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <functional>

#include "base/error.hpp"
#include "sensor_sonar_support.hpp"

namespace meander {
namespace {

using namespace oracle;

const RingLayout kOne{.count = 1, .radius = 0, .first = 0};
constexpr Pose2 kHere{0, 0, 0};

Scene scene_of(const std::vector<std::pair<Shape, Surface>>& things) {
  World world;
  for (const auto& [shape, surface] : things) world.add(obstacle(shape, surface));
  Scene scene;
  scene.follow(world);
  return scene;
}

/// A wall across the x axis at x, turned about the axis's foot point.
Shape wall_at(double x, double turn) { return turned(Chain{{{x, -2}, {x, 2}}, false}, turn, {x, 0}); }

double read(const SonarOptions& options, const Scene& scene) {
  SonarRing ring(kOne, options, 1);
  return scan(ring, scene, kHere)[0];
}

std::vector<double> read_many(const SonarOptions& options, const Scene& scene, int times) {
  SonarRing ring(kOne, options, 5);
  std::vector<double> readings;
  for (int i = 0; i < times; ++i) readings.push_back(scan(ring, scene, kHere)[0]);
  return readings;
}

double share(const std::vector<double>& readings, const std::function<bool(double)>& is) {
  return static_cast<double>(std::count_if(readings.begin(), readings.end(), is)) /
         static_cast<double>(readings.size());
}

TEST(SonarEffects, cone_sees_aside_of_its_axis_as_far_as_its_half_angle) {
  const Scene scene = scene_of({{Disc{{2, 0.3}, 0.02}, {}}});
  SonarOptions o = plain_options();
  EXPECT_NEAR(read(o, scene), std::hypot(2, 0.3) - 0.02, 1e-12);
  o.half_cone = radians(5);
  EXPECT_EQ(read(o, scene), o.range_max);
}

TEST(SonarEffects, readings_stay_within_the_range) {
  SonarOptions o = plain_options();
  o.range_min = 0.5;
  o.range_max = 3;
  EXPECT_EQ(read(o, scene_of({{wall_at(0.2, 0), {}}})), 0.5);
  EXPECT_EQ(read(o, scene_of({{wall_at(3.1, 0), {}}})), 3);
  EXPECT_NEAR(read(o, scene_of({{wall_at(2.9, 0), {}}})), 2.9, 1e-12);
}

TEST(SonarEffects, incidence_rule_silences_slanted_walls) {
  const Scene scene = scene_of({{wall_at(2, radians(50)), {}}});
  SonarOptions o = plain_options();
  EXPECT_LT(read(o, scene), 2);
  o.incidence = true;
  EXPECT_EQ(read(o, scene), o.range_max);
  o.incidence_limit = radians(40);  // reached at the border of the cone, 12.5 degrees aside
  EXPECT_LT(read(o, scene), 2);
}

TEST(SonarEffects, near_field_answers_at_all_incidences) {
  const Scene scene = scene_of({{wall_at(0.25, radians(60)), {}}});
  SonarOptions o = plain_options();
  o.incidence = true;
  EXPECT_EQ(read(o, scene), o.range_max);
  o.near_field = 0.3;
  EXPECT_LT(read(o, scene), 0.3);
}

TEST(SonarEffects, corners_answer_within_their_range) {
  const Scene scene = scene_of({{Rectangle{{2, 0}, {1, 1}, radians(45)}, {}}});
  SonarOptions o = plain_options();
  o.incidence = true;
  EXPECT_EQ(read(o, scene), o.range_max);
  o.corner_range = 1.75;
  EXPECT_NEAR(read(o, scene), 2 - std::sqrt(0.5), 1e-12);
  o.corner_range = 1.25;
  EXPECT_EQ(read(o, scene), o.range_max);
}

TEST(SonarEffects, an_inner_corner_is_no_point_and_a_free_end_is_one) {
  SonarOptions o = plain_options();
  o.incidence = true;
  o.corner_range = 5;
  const Scene room = scene_of({{Polygon{{{-4, -4}, {2, -4}, {2, 4}, {-4, 4}}, {{{-3, -3}, {-3, 3}, {1, 0}}}}, {}}});
  EXPECT_EQ(read(o, room), o.range_max);  // looks into the notch of a hole: two slanted walls
  const Scene end = scene_of({{Chain{{{2, 0}, {4, 0.1}}, false}, {}}});
  EXPECT_NEAR(read(o, end), 2, 1e-12);
}

TEST(SonarEffects, material_has_its_own_limit_and_strength) {
  SonarOptions o = plain_options();
  o.incidence = true;
  const double turn = radians(50);
  EXPECT_EQ(read(o, scene_of({{wall_at(2, turn), {}}})), o.range_max);
  EXPECT_LT(read(o, scene_of({{wall_at(2, turn), {.echo = 1, .specular_limit = radians(80)}}})), 2);
  EXPECT_NEAR(read(o, scene_of({{wall_at(2, 0), {.echo = 0.4, .specular_limit = {}}}})), 2, 1e-12);
  EXPECT_EQ(read(o, scene_of({{wall_at(2, 0), {.echo = 0.3, .specular_limit = {}}}})), o.range_max);  // 0.3 * 6.477 < 2
}

TEST(SonarEffects, what_never_answers_still_hides) {
  SonarOptions o = plain_options();
  for (const bool incidence : {false, true}) {
    o.incidence = incidence;
    o.bounce = true;
    o.corner_range = 10;
    const Surface silent{.echo = 0, .specular_limit = {}};
    EXPECT_EQ(read(o, scene_of({{wall_at(2, 0), silent}, {wall_at(3, 0), {}}})), o.range_max);
    EXPECT_EQ(read(o, scene_of({{Disc{{2, 0}, 0.9}, silent}, {wall_at(4, 0), {}}})), o.range_max);
  }
}

TEST(SonarEffects, noise_has_the_asked_spread) {
  const Scene scene = scene_of({{wall_at(2, 0), {}}});
  SonarOptions o = plain_options();
  o.noise = 0.01;
  o.noise_proportional = 0.01;
  const std::vector<double> readings = read_many(o, scene, 20000);
  double mean = 0, square = 0;
  for (const double r : readings) mean += r / 20000;
  for (const double r : readings) square += (r - mean) * (r - mean) / 20000;
  EXPECT_NEAR(mean, 2, 0.001);
  EXPECT_NEAR(std::sqrt(square), 0.03, 0.001);
  EXPECT_EQ(share(read_many(o, Scene{}, 100), [&](double r) { return r == o.range_max; }), 1);  // silence has no noise
}

TEST(SonarEffects, dropout_spurious_echoes_and_repeats_come_at_their_rates) {
  const Scene scene = scene_of({{wall_at(2, 0), {}}});
  SonarOptions o = plain_options();
  const auto right = [](double r) { return r == 2; };
  EXPECT_EQ(share(read_many(o, scene, 1000), right), 1);
  o.dropout = 0.1;
  EXPECT_NEAR(share(read_many(o, scene, 20000), [&](double r) { return r == o.range_max; }), 0.1, 0.01);
  o.dropout = 0;
  o.spurious = 0.1;
  const std::vector<double> spurious = read_many(o, scene, 20000);
  EXPECT_NEAR(share(spurious, [](double r) { return r < 2; }), 0.1, 0.01);
  EXPECT_GE(*std::min_element(spurious.begin(), spurious.end()), 0.3);
  o.spurious = 0;
  o.noise = 0.01;
  const auto repeats = [&] {
    const std::vector<double> r = read_many(o, scene, 20000);
    int same = 0;
    for (std::size_t i = 1; i < r.size(); ++i) same += r[i] == r[i - 1];
    return same / 19999.0;
  };
  EXPECT_EQ(repeats(), 0);
  o.repeat = 0.1;
  EXPECT_NEAR(repeats(), 0.1, 0.01);
}

TEST(SonarEffects, jitter_of_the_limit_flickers_and_is_held) {
  const Scene scene = scene_of({{wall_at(2, radians(45)), {}}});
  SonarOptions o = plain_options();
  o.incidence = true;  // limit 30 degrees, seen at 32.5 at best
  EXPECT_EQ(share(read_many(o, scene, 200), [&](double r) { return r == o.range_max; }), 1);
  o.incidence_jitter = radians(10);
  for (const double hold : {1.0, 20.0}) {
    o.jitter_hold = hold;
    const std::vector<double> r = read_many(o, scene, 40000);
    const double silent = share(r, [&](double x) { return x == o.range_max; });
    EXPECT_NEAR(silent, 0.599, 0.03) << hold;  // the normal distribution at 0.25 standard deviations
    int jumps = 0;
    for (std::size_t i = 1; i < r.size(); ++i) jumps += (r[i] == o.range_max) != (r[i - 1] == o.range_max);
    EXPECT_NEAR(jumps / 39999.0, 2 * silent * (1 - silent) / hold, 0.02 / std::sqrt(hold)) << hold;
  }
}

TEST(SonarEffects, one_random_effect_does_not_shift_another) {
  const Scene scene = scene_of({{wall_at(2, 0), {}}});
  SonarOptions noise = plain_options();
  noise.noise = 0.01;
  SonarOptions both = noise;
  both.dropout = 0.2;
  both.incidence = true;
  both.incidence_jitter = 0.01;
  const std::vector<double> a = read_many(noise, scene, 500), b = read_many(both, scene, 500);
  int kept = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (b[i] != both.range_max) {
      EXPECT_EQ(a[i], b[i]);
      ++kept;
    }
  EXPECT_GT(kept, 350);
}

TEST(SonarEffects, moving_discs_answer_and_hide_and_ones_own_does_not) {
  Scene scene = scene_of({{wall_at(3, 0), {}}});
  const std::uint32_t me = Scene::kMovingOwner + 3;
  scene.moving = {Pole{Disc{{0, 0}, 0.3}, me, 0}, Pole{Disc{{2, 0}, 0.3}, Scene::kMovingOwner, 0}};
  SonarRing ring(kOne, plain_options(), 1);
  EXPECT_NEAR(scan(ring, scene, kHere, me)[0], 1.7, 1e-12);
  scene.moving.pop_back();
  EXPECT_NEAR(scan(ring, scene, kHere, me)[0], 3, 1e-12);
  EXPECT_EQ(scan(ring, scene, kHere)[0], ring.options().range_min) << "inside a disc that is not one's own";
}

TEST(SonarEffects, presets_are_known_by_name) {
  EXPECT_EQ(sonar_preset_names(), (std::vector<std::string>{"ideal", "nomad", "real"}));
  EXPECT_NEAR(degrees(sonar_preset("ideal").incidence_limit), 60, 1e-9);
  EXPECT_EQ(sonar_preset("nomad").noise, SonarOptions{}.noise);
  EXPECT_TRUE(sonar_preset("real").bounce);
  try {
    sonar_preset("noamd");
    FAIL();
  } catch (const ArgumentError& e) {
    EXPECT_NE(std::string(e.what()).find("did you mean 'nomad'"), std::string::npos) << e.what();
  }
}

TEST(SonarEffects, impossible_options_are_refused) {
  SonarOptions o;
  o.half_cone = 2;
  EXPECT_THROW(SonarRing(RingLayout{}, o, 1), ArgumentError);
  o = {};
  o.range_min = 7;
  EXPECT_THROW(SonarRing(RingLayout{}, o, 1), ArgumentError);
}

}  // namespace
}  // namespace meander
