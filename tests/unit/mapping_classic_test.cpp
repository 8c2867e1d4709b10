// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "geometry/pose.hpp"
#include "mapping/classic_models.hpp"
#include "mapping/cone_places.hpp"

namespace meander {
namespace {

constexpr double kNothing = 6.477;

float told(const SonarModel& model, const std::vector<double>& ranges, float range, float bearing) {
  float log_odds = 99;
  model.evaluate({ranges, kNothing}, {std::span(&range, 1), std::span(&bearing, 1)}, std::span(&log_odds, 1));
  return log_odds;
}

TEST(ConePlaces, AreThoseOfPlainTrigonometry) {
  Stream random(3, "cones");
  for (int i = 0; i < 1000; ++i) {
    const double range = random.uniform(0.25, 3), off = random.uniform(-0.6, 0.6), radius = random.uniform(0, 0.24);
    const SinCos t = sin_cos(off);
    const Vec2 way(range * t.cos - radius, range * t.sin);
    const ConePlace at = cone_place(static_cast<float>(range), static_cast<float>(off), static_cast<float>(radius));
    EXPECT_NEAR(at.distance, way.norm(), 1e-4);
    EXPECT_NEAR(at.angle, std::abs(angle_of(way.y(), way.x())), 1e-3);
  }
}

TEST(ClassicModels, FreeBeforeTheReadingOccupiedAtItNothingBehind) {
  const RingLayout ring = platform("nomad200").sonar;
  for (const SonarModel& model : {cone_model(ring), range_layer_model(ring)}) {
    std::vector<double> ranges(16, 1.0);
    for (int i = 0; i < 16; ++i) {
      const auto bearing = static_cast<float>(2 * kPi * i / 16);
      EXPECT_LT(told(model, ranges, 0.6F, bearing), -0.5) << model.name;
      EXPECT_GT(told(model, ranges, 1.23F, bearing), 0.3) << model.name;
      EXPECT_EQ(told(model, ranges, 1.6F, bearing), 0) << model.name;
      EXPECT_EQ(told(model, ranges, 1.23F, bearing - 6.2831853F), told(model, ranges, 1.23F, bearing)) << model.name;
    }
    EXPECT_EQ(told(model, ranges, static_cast<float>(model.reach + 0.1), 0), 0);
    // Only the reading of the cone counts.
    ranges[4] = 0.5;
    EXPECT_GT(told(model, ranges, 0.73F, static_cast<float>(kPi / 2)), 0.3) << model.name;
    EXPECT_LT(told(model, ranges, 0.73F, static_cast<float>(-kPi / 2)), -0.3) << model.name;
  }
}

TEST(ClassicModels, NoEchoClearsTheConeOfElfesAndRosOnlyWhenAsked) {
  const RingLayout ring = platform("nomad200").sonar;
  const std::vector<double> none(16, kNothing);
  EXPECT_LT(told(cone_model(ring), none, 1, 0), -0.5);
  EXPECT_EQ(told(range_layer_model(ring), none, 1, 0), 0);
  RangeLayerOptions clearing;
  clearing.clear_beyond = true;
  EXPECT_LT(told(range_layer_model(ring, clearing), none, 1, 0), -0.5);
}

TEST(ClassicModels, EveryConeThatHasTheCellIsAsked) {
  ConeModelOptions elfes;
  RangeLayerOptions ros;
  elfes.half_cone = ros.half_cone = 0.5;
  Stream random(4, "rings");
  for (const int count : {1, 2, 3, 4, 5, 16, 37, 72, 300}) {
    const RingLayout ring{count, 0.2, 0.1};
    const auto one = [&](int i) { return RingLayout{1, 0.2, wrap_angle(0.1 + 2 * kPi * i / count)}; };
    for (int trial = 0; trial < 10; ++trial) {
      const auto range = static_cast<float>(random.uniform(0.3, 1.5)), at = static_cast<float>(random.uniform(-3, 3));
      const std::vector<double> ranges(static_cast<std::size_t>(count), 1.0);
      double cones = 0, layers = 0;
      for (int i = 0; i < count; ++i) {
        cones += static_cast<double>(told(cone_model(one(i), elfes), {1.0}, range, at));
        layers += static_cast<double>(told(range_layer_model(one(i), ros), {1.0}, range, at));
      }
      EXPECT_NEAR(told(cone_model(ring, elfes), ranges, range, at), cones, 0.01) << count;
      EXPECT_NEAR(told(range_layer_model(ring, ros), ranges, range, at), layers, 0.01) << count;
    }
  }
}

TEST(ClassicModels, RobotWithoutSonarsIsRefused) {
  const RingLayout none = platform("alice").sonar;
  ASSERT_EQ(none.count, 0);
  EXPECT_THROW(cone_model(none), ArgumentError);
  EXPECT_THROW(range_layer_model(none), ArgumentError);
  const float nan = std::nanf("");
  EXPECT_EQ(told(cone_model({}), std::vector<double>(16, 1.0), nan, 0), 0);
  EXPECT_EQ(told(cone_model({}), std::vector<double>(16, 1.0), 1, nan), 0);
}

TEST(ClassicModels, OptionsOutOfRangeAreErrors) {
  ConeModelOptions cone;
  cone.half_cone = 2;
  EXPECT_THROW(cone_model({}, cone), ArgumentError);
  RangeLayerOptions layer;
  layer.tolerance = 0;
  EXPECT_THROW(range_layer_model({}, layer), ArgumentError);
}

}  // namespace
}  // namespace meander
