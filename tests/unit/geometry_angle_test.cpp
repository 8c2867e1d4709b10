// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/angle.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/hash.hpp"
#include "base/random.hpp"
#include "geometry/pose.hpp"

namespace meander {
namespace {

constexpr double kLargest = 1e5;

/// Angles where reductions go wrong: around multiples of pi/4, tiny, and anything up to the documented limit.
double nasty_angle(Stream& random) {
  switch (random.below(4)) {
    case 0:
      return random.uniform(-4, 4);
    case 1:
      return random.uniform(-kLargest, kLargest);
    case 2: {
      const double quarter = (random.below(200001) - 100000) * (kPi / 4);
      return std::clamp(quarter + random.normal() * std::pow(10, -random.uniform(0, 17)), -kLargest, kLargest);
    }
    default:
      return random.normal() * std::pow(10, -random.uniform(0, 300));
  }
}

TEST(Angle, SineAndCosineAreRightTo1e15) {
  Stream random(1, "angles");
  double worst = 0;
  for (int i = 0; i < 400'000; ++i) {
    const double angle = nasty_angle(random);
    const SinCos t = sin_cos(angle);
    worst = std::max({worst, static_cast<double>(std::abs(t.sin - std::sin(static_cast<long double>(angle)))),
                      static_cast<double>(std::abs(t.cos - std::cos(static_cast<long double>(angle))))});
  }
  EXPECT_LE(worst, 1e-15);
  RecordProperty("worst", std::to_string(worst * 1e16) + "e-16");
}

TEST(Angle, QuadrantsAreExact) {
  EXPECT_EQ(sin_cos(0).sin, 0);
  EXPECT_EQ(sin_cos(0).cos, 1);
  EXPECT_EQ(sin_cos(kPi / 2).sin, 1);
  EXPECT_EQ(sin_cos(-kPi / 2).sin, -1);
  EXPECT_EQ(sin_cos(kPi).cos, -1);
  EXPECT_LE(std::abs(sin_cos(kPi / 2).cos), 1e-16);
  Stream random(2, "symmetry");
  for (int i = 0; i < 100000; ++i) {
    const double angle = nasty_angle(random);
    const SinCos plus = sin_cos(angle), minus = sin_cos(-angle);
    EXPECT_EQ(plus.sin, -minus.sin);
    EXPECT_EQ(plus.cos, minus.cos);
  }
}

TEST(Angle, AngleOfIsRightTo1e15) {
  Stream random(3, "atan");
  double worst = 0;
  for (int i = 0; i < 400'000; ++i) {
    double x = random.normal(), y = random.normal();
    if (random.chance(0.3)) y *= std::pow(10, -random.uniform(0, 300));
    if (random.chance(0.3)) x *= std::pow(10, -random.uniform(0, 300));
    if (random.chance(0.1)) x = y * (random.chance(0.5) ? 1 : -1);
    const double angle = angle_of(y, x);
    const long double right = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    // Where the right angle rounds to -pi, pi is given.
    const long double off = std::remainder(angle - right, 2 * std::numbers::pi_v<long double>);
    worst = std::max(worst, static_cast<double>(std::abs(off)));
    EXPECT_TRUE(angle > -kPi && angle <= kPi);
  }
  EXPECT_LE(worst, 1e-15);
}

TEST(Angle, AngleOfAxesAndDegenerateVectors) {
  EXPECT_EQ(angle_of(0, 1), 0);
  EXPECT_EQ(angle_of(1, 0), kPi / 2);
  EXPECT_EQ(angle_of(0, -1), kPi);
  EXPECT_EQ(angle_of(-0.0, -1), kPi) << "in (-pi, pi]";
  EXPECT_EQ(angle_of(-1, 0), -kPi / 2);
  EXPECT_EQ(angle_of(0, 0), 0);
  EXPECT_EQ(angle_of(-1e-300, -1), kPi) << "in (-pi, pi], though it rounds to -pi";
  EXPECT_NEAR(angle_of(1e-320, 1e-320), kPi / 4, 1e-15);
  EXPECT_NEAR(angle_of(1e308, 1e308), kPi / 4, 1e-15);
}

TEST(Angle, AngleOfUndoesSinCos) {
  Stream random(4, "inverse");
  for (int i = 0; i < 200000; ++i) {
    const double angle = random.uniform(-kPi, kPi);
    const SinCos t = sin_cos(angle);
    EXPECT_NEAR(angle_of(t.sin, t.cos), angle, 1e-15);
  }
}

TEST(Angle, WrappedAnglesAreInRangeAndTheSameDirection) {
  Stream random(5, "wrap");
  for (int i = 0; i < 100000; ++i) {
    const double angle = nasty_angle(random), wrapped = wrap_angle(angle);
    EXPECT_TRUE(wrapped > -kPi && wrapped <= kPi) << angle;
    EXPECT_EQ(wrap_angle(wrapped), wrapped);
    EXPECT_NEAR(std::remainder(static_cast<long double>(angle) - wrapped, 2 * std::numbers::pi_v<long double>), 0,
                1e-15 * (4 + std::abs(angle)));
    const double other = random.uniform(-kPi, kPi);
    EXPECT_NEAR(std::remainder(other + angle_between(other, wrapped) - wrapped, 2 * kPi), 0, 2e-15);
  }
  EXPECT_EQ(wrap_angle(kPi), kPi);
  EXPECT_EQ(wrap_angle(-kPi), kPi);
  EXPECT_EQ(wrap_angle(3 * kPi), kPi);
  EXPECT_EQ(wrap_angle(-3 * kPi), kPi);
  EXPECT_EQ(wrap_angle(2 * kPi), 0);
  EXPECT_EQ(wrap_angle(0.25), 0.25);
}

TEST(Angle, HasTheSameBitsEverywhere) {
  Stream random(6, "golden");
  Hash hash;
  for (int i = 0; i < 10000; ++i) {
    const double angle = random.uniform(-kLargest, kLargest);
    const SinCos t = sin_cos(angle);
    hash.add(t.sin).add(t.cos).add(angle_of(t.sin, t.cos)).add(wrap_angle(angle));
  }
  EXPECT_EQ(hash.hex(), "d6386cd466b492c8");
}

TEST(Pose, IsAGroup) {
  Stream random(7, "poses");
  const auto any = [&] { return Pose2{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-3.1, 3.1)}; };
  const auto close = [](const Pose2& a, const Pose2& b) {
    return (a.position() - b.position()).norm() < 1e-13 * 100 && std::abs(angle_between(a.heading, b.heading)) < 1e-14;
  };
  for (int i = 0; i < 10000; ++i) {
    const Pose2 a = any(), b = any(), c = any();
    EXPECT_TRUE(close((a * b) * c, a * (b * c)));
    EXPECT_TRUE(close(a * inverse(a), Pose2{}));
    EXPECT_TRUE(close(inverse(a) * a, Pose2{}));
    const Vec2 p(random.uniform(-9, 9), random.uniform(-9, 9));
    EXPECT_LE((a * (b * p) - (a * b) * p).norm(), 1e-12);
    EXPECT_LE((a * Vec2(1, 0) - a.position() - a.direction()).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace meander
