// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "geometry/segment.hpp"
#include "geometry/shapes.hpp"

namespace meander {
namespace {

Vec2 random_point(Stream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// A shape of any kind within about 5 m of the origin.
Shape random_shape(Stream& random) {
  std::vector<Vec2> ring;
  for (int i = 0; i < 9; ++i) {
    const SinCos t = sin_cos((i + random.uniform(0.1, 0.9)) * 2 * kPi / 9);
    ring.push_back(random.uniform(2, 5) * Vec2(t.cos, t.sin));
  }
  switch (random.below(4)) {
    case 0:
      return Chain{ring, random.chance(0.5)};
    case 1:
      return Polygon{ring, {{{0.5, 0}, {0, 0.5}, {-0.5, 0}, {0, -0.5}}}};
    case 2:
      return Rectangle{
          random_point(random, 2), {random.uniform(0.1, 3), random.uniform(0.1, 3)}, random.uniform(-3, 3)};
    default:
      return Disc{random_point(random, 2), random.uniform(0.1, 3)};
  }
}

TEST(Shapes, MotionIsASimilarity) {
  Stream random(1, "similarity");
  for (int i = 0; i < 2000; ++i) {
    const Shape shape = random_shape(random);
    const Vec2 p = random_point(random, 8), by = random_point(random, 20), about = random_point(random, 20);
    const double angle = random.uniform(-7, 7), factor = random.uniform(0.1, 4);
    const double d = distance(shape, p);
    EXPECT_NEAR(distance(moved(shape, by), p + by), d, 1e-12);
    const SinCos t = sin_cos(angle);
    const Vec2 arm = p - about;
    EXPECT_NEAR(distance(turned(shape, angle, about),
                         about + Vec2(t.cos * arm.x() - t.sin * arm.y(), t.sin * arm.x() + t.cos * arm.y())),
                d, 1e-12);
    EXPECT_NEAR(distance(scaled(shape, factor, about), about + factor * arm), factor * d, 1e-12);
  }
}

TEST(Shapes, ContainsIsDistanceZeroForSolids) {
  Stream random(2, "contains");
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    const Shape shape = random_shape(random);
    const Vec2 p = random_point(random, 6);
    if (std::holds_alternative<Chain>(shape)) {
      EXPECT_FALSE(contains(shape, p));
    } else {
      EXPECT_EQ(contains(shape, p), distance(shape, p) == 0);
      inside += contains(shape, p);
      EXPECT_TRUE(!contains(shape, p) || bounding_box(shape).contains(p));
    }
  }
  EXPECT_GT(inside, 300);
}

TEST(Shapes, EveryRimPointIsInside) {
  Stream random(3, "rim");
  for (int i = 0; i < 500; ++i) {
    const Shape shape = moved(random_shape(random), random_point(random, 900));
    if (std::holds_alternative<Chain>(shape)) continue;
    for (const Ring& ring : rings(shape))
      for (std::size_t k = 0; k < ring.points.size(); ++k) {
        const Vec2 a = ring.points[k], b = ring.points[(k + 1) % ring.points.size()];
        EXPECT_TRUE(contains(shape, a));
        EXPECT_TRUE(contains(shape, a + random.uniform() * (b - a)));
      }
  }
}

TEST(Shapes, CanonicalOrdersRingsAndChangesNoArea) {
  Stream random(4, "canonical");
  for (int i = 0; i < 500; ++i) {
    const Shape shape = random_shape(random);
    Shape back = shape;
    if (auto* p = std::get_if<Polygon>(&back)) std::reverse(p->outer.begin() + 1, p->outer.end());
    EXPECT_EQ(canonical(back), canonical(shape));
    EXPECT_EQ(canonical(canonical(shape)), canonical(shape));
  }
  const Polygon p =
      std::get<Polygon>(canonical(Polygon{{{0, 0}, {0, 4}, {4, 4}, {4, 0}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}}));
  EXPECT_EQ(p.outer, (std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(p.holes[0], (std::vector<Vec2>{{1, 1}, {1, 2}, {2, 2}, {2, 1}}));
}

TEST(Shapes, UndoneMotionReturnsExactlyWhenNothingRounds) {
  const Shape shape = Rectangle{{1, 2}, {3, 4}, 0.7};
  EXPECT_EQ(moved(moved(shape, {0.5, -8}), {-0.5, 8}), shape);
  EXPECT_EQ(scaled(scaled(shape, 4, {0, 0}), 0.25, {0, 0}), shape);
  EXPECT_EQ(turned(shape, 0, {5, 5}), shape);
}

TEST(Shapes, BoxCentreAndRings) {
  const Shape rectangle = Rectangle{{1, 2}, {4, 2}, kPi / 2};
  EXPECT_NEAR(bounding_box(rectangle).low.x(), 0, 1e-15);
  EXPECT_NEAR(bounding_box(rectangle).high.y(), 4, 1e-15);
  EXPECT_EQ(rings(rectangle).size(), 1u);
  EXPECT_EQ(rings(rectangle)[0].points.size(), 4u);
  EXPECT_EQ(bounding_box(Disc{{1, 1}, 2}), (Box{{-1, -1}, {3, 3}}));
  EXPECT_TRUE(rings(Disc{{1, 1}, 2}).empty());
  EXPECT_EQ(center(Chain{{{0, 0}, {4, 2}}, false}), Vec2(2, 1));
  EXPECT_DOUBLE_EQ(distance(Chain{{{0, 0}, {4, 0}, {4, 4}}, true}, {1, 3}), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(distance_to_segment({2, 5}, {0, 0}, {4, 0}), 5);
  EXPECT_DOUBLE_EQ(distance_to_segment({7, 4}, {0, 0}, {4, 0}), 5);
}

TEST(Shapes, AHoleIsOutside) {
  const Shape ring = Polygon{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}}};
  EXPECT_FALSE(contains(ring, {2, 2}));
  EXPECT_DOUBLE_EQ(distance(ring, {2, 2.5}), 0.5);
  EXPECT_TRUE(contains(ring, {0.5, 2}));
  EXPECT_TRUE(contains(ring, {1, 2}));
}

}  // namespace
}  // namespace meander
