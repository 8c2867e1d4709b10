// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <limits>

#include "base/random.hpp"
#include "geometry/segment.hpp"
#include "geometry/shapes.hpp"

namespace meander {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string complaint(const Shape& shape) { return invalid(shape).value_or("valid"); }

/// A ring around the origin with growing angles: never crosses itself.
std::vector<Vec2> star(Stream& random, int count) {
  std::vector<Vec2> ring;
  for (int i = 0; i < count; ++i) {
    const SinCos t = sin_cos((i + random.uniform(0.1, 0.9)) * 2 * kPi / count);
    const double r = random.uniform(1, 5);
    ring.emplace_back(r * t.cos, r * t.sin);
  }
  return ring;
}

bool edges_cross(const std::vector<Vec2>& p) {
  const auto at = [&](std::size_t i) { return p[i % p.size()]; };
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 2; j < p.size(); ++j) {
      if (i == 0 && j + 1 == p.size()) continue;
      const Vec2 a = at(i), b = at(i + 1), c = at(j), d = at(j + 1);
      if ((cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0) &&
          (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0))
        return true;
    }
  return false;
}

TEST(Validity, StarsAreValidEitherWayRound) {
  Stream random(1, "stars");
  for (int i = 0; i < 300; ++i) {
    std::vector<Vec2> ring = star(random, 3 + random.below(40));
    EXPECT_EQ(complaint(Polygon{ring, {}}), "valid");
    std::reverse(ring.begin(), ring.end());
    EXPECT_EQ(complaint(Polygon{ring, {}}), "valid");
  }
}

TEST(Validity, RandomRingsAreJudgedLikeBySegmentTests) {
  Stream random(2, "rings");
  int bad = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec2> ring(static_cast<std::size_t>(4 + random.below(4)));
    for (Vec2& p : ring) p = {random.uniform(-10, 10), random.uniform(-10, 10)};
    const auto said = invalid(Polygon{ring, {}});
    EXPECT_EQ(said.has_value(), edges_cross(ring)) << said.value_or("valid");
    if (!said) continue;
    EXPECT_NE(said->find("meet at"), std::string::npos) << *said;
    ++bad;
  }
  EXPECT_GT(bad, 500);
}

TEST(Validity, MotionKeepsValidity) {
  Stream random(3, "motion");
  for (int i = 0; i < 200; ++i) {
    const Shape shape = Polygon{star(random, 12), {}};
    const Vec2 somewhere(random.uniform(-1000, 1000), random.uniform(-1000, 1000));
    EXPECT_EQ(complaint(scaled(turned(moved(shape, somewhere), random.uniform(-7, 7), somewhere), 0.3, somewhere)),
              "valid");
  }
}

TEST(Validity, FineDetailInAWideShapeIsKept) {
  const Polygon notch{{{0, 0}, {1000, 0}, {1000, 1000}, {2e-5, 1000}, {1e-5, 1e-5}, {0, 1000}}, {}};
  EXPECT_EQ(complaint(notch), "valid");
}

TEST(Validity, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint(Polygon{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}}), "edge 1-2 and edge 3-4 meet at (2, 2)");
  EXPECT_EQ(complaint(Polygon{{{0, 0}, {1, 0}}, {}}), "at least 3 points expected, got 2");
  EXPECT_EQ(complaint(Polygon{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}, {}}), "points 2 and 3 are the same, (1, 0)");
  EXPECT_EQ(complaint(Polygon{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}, {}}),
            "points 4 and 1 are the same, (0, 0); rings are closed without repeating the first point");
  EXPECT_EQ(complaint(Polygon{{{0, 0}, {1, 0}, {2, 0}}, {}}), "edge 1-2 and edge 3-1 overlap at (0, 0)");
  EXPECT_EQ(complaint(Chain{{{0, 0}, {kNan, 1}}, false}),
            "point 2: two finite numbers within +-1e+06 m expected, got (nan, 1)");
  EXPECT_EQ(complaint(Chain{{{0, 0}}, false}), "at least 2 points expected, got 1");
  EXPECT_EQ(complaint(Chain{{}, false}), "at least 2 points expected, got 0");
  EXPECT_EQ(complaint(Chain{{{0, 0}, {1, 0}}, true}), "at least 3 points expected, got 2");
  EXPECT_EQ(complaint(Rectangle{{0, 0}, {1, 0}, 0}), "size: height: a number from 1e-06 to 1e+06 m expected, got 0");
  EXPECT_EQ(complaint(Rectangle{{0, 0}, {-1, 1}, 0}), "size: width: a number from 1e-06 to 1e+06 m expected, got -1");
  EXPECT_EQ(complaint(Rectangle{{0, 2e6}, {1, 1}, 0}),
            "center: two finite numbers within +-1e+06 m expected, got (0, 2000000)");
  EXPECT_EQ(complaint(Rectangle{{0, 0}, {1, 1}, kNan}), "heading: an angle within +-1e+06 rad expected, got nan");
  EXPECT_EQ(complaint(Disc{{0, 0}, std::numeric_limits<double>::infinity()}),
            "radius: a number from 1e-06 to 1e+06 m expected, got inf");
  EXPECT_EQ(complaint(Disc{{0, 0}, 0.1}), "valid");
  EXPECT_EQ(complaint(Chain{std::vector<Vec2>(kMostPoints + 1), false}),
            "at most 1000000 points expected, got 1000001");
}

TEST(Validity, Holes) {
  const std::vector<Vec2> outer{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const std::vector<Vec2> hole{{1, 1}, {4, 1}, {4, 4}, {1, 4}};
  const auto shifted = [&](double dx, double dy) {
    std::vector<Vec2> ring = hole;
    for (Vec2& p : ring) p += Vec2(dx, dy);
    return ring;
  };
  EXPECT_EQ(complaint(Polygon{outer, {hole, shifted(5, 5)}}), "valid");
  EXPECT_EQ(complaint(Polygon{outer, {shifted(20, 0)}}), "hole 1 at (21, 1) lies outside the outer ring");
  EXPECT_EQ(complaint(Polygon{outer, {hole, {{2, 2}, {3, 2}, {3, 3}, {2, 3}}}}), "hole 2 at (2, 2) lies inside hole 1");
  EXPECT_EQ(complaint(Polygon{outer, {shifted(8, 0)}}), "edge 2-3 of outer and edge 1-2 of hole 1 meet at (10, 1)");
  EXPECT_EQ(complaint(Polygon{outer, {hole, shifted(1, 1)}}),
            "edge 2-3 of hole 1 and edge 1-2 of hole 2 meet at (4, 2)");
  EXPECT_EQ(complaint(Polygon{outer, {{{1, 1}, {2, 2}}}}), "hole 1: at least 3 points expected, got 2");
}

}  // namespace
}  // namespace meander
