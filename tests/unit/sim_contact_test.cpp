// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sim/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"

namespace meander {
namespace {

Vec2 any_point(Stream& random, double size) { return {random.uniform(-size, size), random.uniform(-size, size)}; }

/// First share of the way at which the distance is within reach, by dense sampling and bisection.
template <class Distance>
double sampled(const Vec2& from, const Vec2& by, double reach, Distance distance) {
  constexpr int kSamples = 20000;
  for (int i = 1; i <= kSamples; ++i) {
    double high = static_cast<double>(i) / kSamples;
    if (distance(from + high * by) > reach) continue;
    double low = static_cast<double>(i - 1) / kSamples;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (distance(from + middle * by) > reach ? low : high) = middle;
    }
    return high;
  }
  return kFreeWay;
}

TEST(WayToSegment, EqualsDenseSampling) {
  Stream random(1, "ways");
  int met = 0;
  for (int i = 0; i < 1500; ++i) {
    const Vec2 a = any_point(random, 1), b = any_point(random, 1), from = any_point(random, 2),
               by = any_point(random, 2);
    const double reach = random.uniform(0.01, 0.5);
    const auto distance = [&](const Vec2& p) { return distance_to_segment(p, a, b); };
    if (distance(from) <= reach) continue;
    const double share = way_to_segment(from, by, reach, a, b);
    const double expected = sampled(from, by, reach, distance);
    met += share < 1;
    // A graze shorter than the sampling may be missed by the samples, never by the closed form.
    if (expected == kFreeWay && share <= 1)
      EXPECT_NEAR(distance(from + share * by), reach, 1e-9);
    else
      EXPECT_NEAR(share, expected, 1e-9) << i;
  }
  EXPECT_GT(met, 100);
}

TEST(WayToPoint, StopsExactlyAtReach) {
  Stream random(2, "ways");
  for (int i = 0; i < 5000; ++i) {
    const Vec2 from = any_point(random, 2), by = any_point(random, 2), point = any_point(random, 1);
    const double reach = random.uniform(0, 0.5);
    if ((from - point).norm() <= reach) continue;
    const double share = way_to_point(from, by, reach, point);
    if (share <= 1) {
      EXPECT_NEAR((from + share * by - point).norm(), reach, 1e-12);
    } else {
      EXPECT_GT(distance_to_segment(point, from, from + by), reach - 1e-12);
    }
  }
}

TEST(WayToSegment, WhoStandsAtTheMarginGoesNoFurther) {
  Stream random(3, "ways");
  for (int i = 0; i < 5000; ++i) {
    const Vec2 a = any_point(random, 5), b = any_point(random, 5), by = any_point(random, 0.1);
    const double reach = random.uniform(0.1, 0.5);
    Vec2 at = any_point(random, 6);
    for (int push = 0; push < 4; ++push) {
      const double share = way_to_segment(at, by, reach, a, b);
      if (distance_to_segment(at, a, b) < reach - 1e-12) break;  // started inside
      at += std::min(share, 1.0) * by;
      EXPECT_GE(distance_to_segment(at, a, b), reach - 1e-12);
    }
  }
}

TEST(WayOut, OnlyAwayFromWhatIsTooNear) {
  const Vec2 a{-1, 0}, b{1, 0};
  EXPECT_EQ(way_to_segment({0, 0.1}, {0, 0.5}, 0.3, a, b), kFreeWay);  // away
  EXPECT_EQ(way_to_segment({0, 0.1}, {0.5, 0}, 0.3, a, b), kFreeWay);  // along
  EXPECT_EQ(way_to_segment({0, 0.1}, {0.5, -0.01}, 0.3, a, b), 0);     // nearer
  EXPECT_EQ(way_to_segment({1.1, 0}, {-0.1, 0.05}, 0.3, a, b), 0);     // nearer to the end
  EXPECT_EQ(way_to_point({0, 0}, {1, 0}, 0.3, {0, 0}), kFreeWay);      // on top of it: any way leads out
  EXPECT_EQ(way_to_point({0.1, 0}, {0, 0}, 0.3, {0, 0}), kFreeWay);    // standing still
}

}  // namespace
}  // namespace meander
