// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/clip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"

namespace meander {
namespace {

const Box kBox{{-1, -2}, {3, 2}};

std::vector<Vec2> random_points(Stream& random, int count, double reach) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) points.emplace_back(random.uniform(-reach, reach), random.uniform(-reach, reach));
  return points;
}

/// Even-odd rule.
bool in_ring(const std::vector<Vec2>& ring, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

bool within(const Box& box, const Vec2& p) {
  const Vec2 slack(1e-9, 1e-9);
  return Box{box.low - slack, box.high + slack}.contains(p);
}

TEST(Clip, RingsCoverTheSamePointsOfTheBox) {
  Stream random(1, "rings");
  for (int round = 0; round < 500; ++round) {
    const auto ring = random_points(random, 3 + random.below(8), 6);
    const auto part = clipped_ring(ring, kBox);
    for (const Vec2& p : part) ASSERT_TRUE(within(kBox, p));
    for (int i = 0; i < 40; ++i) {
      const Vec2 p(random.uniform(-0.99, 2.99), random.uniform(-1.99, 1.99));
      ASSERT_EQ(in_ring(part, p), in_ring(ring, p)) << round;
    }
  }
}

double length(const std::vector<Vec2>& points, bool closed) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return closed ? sum + (points.front() - points.back()).norm() : sum;
}

/// Length of the run inside the box, by small steps.
double length_inside(std::vector<Vec2> points, bool closed) {
  if (closed) points.push_back(points.front());
  constexpr int kSteps = 4000;
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 way = points[i] - points[i - 1];
    for (int k = 0; k < kSteps; ++k)
      if (kBox.contains(points[i - 1] + way * ((k + 0.5) / kSteps))) sum += way.norm() / kSteps;
  }
  return sum;
}

TEST(Clip, LinesKeepWhatLiesInTheBox) {
  Stream random(2, "lines");
  for (int round = 0; round < 200; ++round) {
    const auto points = random_points(random, 2 + random.below(6), 5);
    const bool closed = random.chance(0.5);
    double sum = 0;
    for (const Ring& part : clipped_line(points, closed, kBox)) {
      ASSERT_GE(part.points.size(), 2u);
      for (const Vec2& p : part.points) ASSERT_TRUE(within(kBox, p));
      sum += length(part.points, part.closed);
    }
    ASSERT_NEAR(sum, length_inside(points, closed), 0.05) << round;
  }
}

TEST(Clip, WhatLiesInsideIsLeftAsItIs) {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {1, 1}};
  EXPECT_EQ(clipped_ring(points, kBox), points);
  const auto parts = clipped_line(points, true, kBox);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_TRUE(parts[0].closed);
  EXPECT_EQ(parts[0].points, points);
}

TEST(Clip, WhatLiesOutsideIsGone) {
  EXPECT_TRUE(clipped_ring({{10, 0}, {11, 0}, {11, 1}}, kBox).empty());
  EXPECT_TRUE(clipped_line({{10, 0}, {11, 0}, {11, 1}}, true, kBox).empty());
}

TEST(Clip, CirclesStayWithinATenthOfAUnit) {
  for (const double units : {0.1, 1.0, 7.0, 300.0, 15'000.0}) {
    const auto points = circle({{2, 3}, 5}, units);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 middle = 0.5 * (points[i] + points[(i + 1) % points.size()]);
      ASSERT_NEAR((points[i] - Vec2(2, 3)).norm(), 5, 1e-9);
      ASSERT_LE((5 - (middle - Vec2(2, 3)).norm()) / 5 * units, 0.1);
    }
  }
}

}  // namespace
}  // namespace meander
