// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "robot/drift.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/kinematics.hpp"

namespace meander {
namespace {

TEST(DriftTest, WithoutErrorsOdometryIsTheTruth) {
  Stream random(1, "path");
  Drift drift({}, 7);
  Pose2 truth{1, 2, 0.5}, told = truth;
  for (int i = 0; i < 5000; ++i) {
    const Pose2 next = arc(truth, random.uniform(-1, 1), random.uniform(-2, 2), 0.1);
    told = drift.advance(told, truth, next);
    truth = next;
  }
  EXPECT_NEAR(told.x, truth.x, 1e-9);
  EXPECT_NEAR(told.y, truth.y, 1e-9);
  EXPECT_NEAR(angle_between(told.heading, truth.heading), 0, 1e-9);
}

TEST(DriftTest, SystematicErrorsScaleTheMotion) {
  Drift drift({.distance_bias = 0.1, .veer = 0.02}, 7);
  Pose2 truth, told;
  for (int i = 0; i < 100; ++i) {
    const Pose2 next = arc(truth, 1, 0, 0.1);
    told = drift.advance(told, truth, next);
    truth = next;
  }
  EXPECT_NEAR(told.heading, 0.02 * 10, 1e-12);
  EXPECT_NEAR(told.x, 11 * std::sin(0.2) / 0.2, 1e-9);  // an arc of 11 m that turns by 0.2 rad

  Drift turning({.turn_bias = -0.5}, 7);
  EXPECT_NEAR(turning.advance({}, {}, {0, 0, 1}).heading, 0.5, 1e-12);
}

TEST(DriftTest, BackwardsIsToldAsBackwards) {
  Drift drift({.distance_bias = 0.1}, 7);
  EXPECT_NEAR(drift.advance({}, {}, arc({}, -1, 0.4, 0.5)).x, arc({}, -1.1, 0.4, 0.5).x, 1e-12);
}

/// The spread after one metre must not depend on the number of pieces it was driven in.
TEST(DriftTest, NoiseGrowsWithTheRootOfTheWay) {
  for (const int pieces : {1, 10, 100}) {
    double sum = 0;
    constexpr int kRuns = 4000;
    for (int run = 0; run < kRuns; ++run) {
      Drift drift({.distance_noise = 0.05}, static_cast<std::uint64_t>(run));
      Pose2 truth, told;
      for (int i = 0; i < pieces; ++i) {
        const Pose2 next = arc(truth, 1, 0, 1.0 / pieces);
        told = drift.advance(told, truth, next);
        truth = next;
      }
      sum += (told.x - 1) * (told.x - 1);
    }
    EXPECT_NEAR(std::sqrt(sum / kRuns), 0.05, 0.003) << pieces;
  }
}

TEST(DriftTest, StandingStillTellsNothing) {
  Drift drift(drift_preset("poor"), 7);
  const Pose2 odometry{1, 2, 3};
  EXPECT_EQ(drift.advance(odometry, {4, 5, 1}, {4, 5, 1}), odometry);
}

TEST(DriftTest, CopiesForkTheStream) {
  Drift a(drift_preset("poor"), 7);
  a.advance({}, {}, {0.1, 0, 0});
  Drift b = a;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.advance({}, {}, {0.1, 0, 0.1}), b.advance({}, {}, {0.1, 0, 0.1}));
  Hash ha, hb;
  a.add_to(ha);
  b.add_to(hb);
  EXPECT_EQ(ha.value(), hb.value());
}

TEST(DriftTest, PresetsAreValidAndMisuseIsNamed) {
  for (const std::string& name : drift_preset_names()) EXPECT_NO_THROW(validate(drift_preset(name)));
  EXPECT_THROW(drift_preset("godo"), ArgumentError);
  EXPECT_THROW(Drift({.turn_noise = -1}, 1), ArgumentError);
}

TEST(DriftTest, SlipIsAShareOfTheWayAndTurnsSlowly) {
  // Straight ahead in steps of 5 cm, as [Z] section 1 has it: 20 to 25 % of the way, hardly turned from step to step.
  DriftOptions slip;
  slip.slip = 0.225;
  slip.slip_spread = 0.025;
  Drift drift(slip, 3, DriveKind::omnidirectional);
  double alike = 0;
  Vec2 before(0, 0);
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const Pose2 told = drift.advance({0, 0, 0}, {0, 0, 0}, {0.03, 0.04, 0});
    const Vec2 error = told.position() - Vec2(0.03, 0.04);
    EXPECT_GE(error.norm(), 0.2 * 0.05 - 1e-12);
    EXPECT_LE(error.norm(), 0.25 * 0.05 + 1e-12);
    if (i > 0) alike += error.normalized().dot(before.normalized());
    before = error;
  }
  EXPECT_NEAR(alike / (kSteps - 1), 0.9512, 0.005);  // e^-0.05
}

}  // namespace
}  // namespace meander
