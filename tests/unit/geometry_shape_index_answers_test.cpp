// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_index.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace meander {
namespace {

Vec2 direction(double angle) {
  const SinCos t = sin_cos(angle);
  return {t.cos, t.sin};
}

std::vector<Wall> walls_of(const Shape& shape) {
  ShapeIndex index;
  index.insert(3, shape, {.echo = 0.5});
  std::vector<Wall> walls;
  std::vector<Pole> poles;
  index.gather({0, 0}, 1e7, walls, poles);
  for (const Wall& w : walls) {
    EXPECT_EQ(w.owner, 3u);
    EXPECT_EQ(index.material(w.material).echo, 0.5);
  }
  return walls;
}

std::string corners_of(const Shape& shape) {
  std::string text;
  for (const Wall& w : walls_of(shape)) text += std::string(w.convex_a ? "A" : "-") + (w.convex_b ? "B" : "");
  return text;
}

TEST(ShapeIndex, SolidsLieLeftOfTheirWallsAndConvexCornersAreMarked) {
  const std::vector<Vec2> ell{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  EXPECT_EQ(corners_of(Polygon{ell, {}}), "AAA-AA");
  EXPECT_EQ(corners_of(Polygon{{ell.rbegin(), ell.rend()}, {}}), "AAAA-A");
  EXPECT_EQ(corners_of(Polygon{{{0, 0}, {2, 0}, {4, 0}, {4, 4}}, {}}), "A-AA");
  const Polygon frame{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {6, 3}, {6, 6}, {3, 6}}}};
  EXPECT_EQ(corners_of(frame), "AAAA----");
  EXPECT_EQ(corners_of(Rectangle{{1, 2}, {3, 4}, 0.3}), "AAAA");
  EXPECT_EQ(corners_of(Chain{{{0, 0}, {1, 0}, {2, 0}, {2, 1}}, false}), "A-AB");
  EXPECT_EQ(corners_of(Chain{{{0, 0}, {1, 0}, {1, 1}}, true}), "AAA");
  EXPECT_EQ(corners_of(Disc{{0, 0}, 1}), "");
  for (const Shape& shape : {Shape(frame), Shape(Rectangle{{1, 2}, {3, 4}, 0.3}), Shape(Polygon{ell, {}})})
    for (const Wall& w : walls_of(shape)) {
      const Vec2 left = 0.5 * (w.a + w.b) + 0.01 * left_of(w.b - w.a).normalized();
      EXPECT_TRUE(w.solid && contains(shape, left));
    }
}

TEST(ShapeIndex, HitsTellOwnerPointAndIncidence) {
  ShapeIndex index;
  index.insert(4, Rectangle{{5, 0}, {2, 2}, 0});
  index.insert(7, Disc{{0, 5}, 1});
  const auto wall = index.cast({0, 0}, {1, 0}, 10);
  ASSERT_TRUE(wall);
  EXPECT_EQ(wall->owner, 4u);
  EXPECT_DOUBLE_EQ(wall->range, 4);
  EXPECT_NEAR(wall->incidence(), 0, 1e-7);
  const auto slanting = index.cast({0, 0}, direction(0.1), 10);
  EXPECT_NEAR(slanting->incidence(), 0.1, 1e-12);
  const auto pole = index.cast({0.5, 0}, {0, 1}, 10);
  EXPECT_EQ(pole->owner, 7u);
  EXPECT_NEAR(pole->incidence(), kPi / 6, 1e-12);
  EXPECT_FALSE(index.cast({0, 0}, {1, 0}, 3.999));
  EXPECT_FALSE(index.cast({0, 0}, {-1, 0}, 1e9));
  EXPECT_DOUBLE_EQ(index.cast({5, 0}, {1, 0}, 10)->range, 1);  // from inside
  EXPECT_DOUBLE_EQ(index.cast({-1e6, 0}, {1, 0}, 1e9)->range, 1e6 + 4);
}

TEST(ShapeIndex, AWallSeenEndOnIsHitAtItsNearerEnd) {
  ShapeIndex index;
  index.insert(0, Chain{{{2, 0}, {5, 0}}, false});
  index.insert(1, Chain{{{6, 0}, {8, 0}}, false});
  EXPECT_DOUBLE_EQ(index.cast({0, 0}, {1, 0}, 10)->range, 2);
  EXPECT_NEAR(index.cast({0, 0}, {1, 0}, 10)->incidence(), kPi / 2, 1e-12);
  EXPECT_DOUBLE_EQ(index.cast({3, 0}, {1, 0}, 10)->range, 0);
  EXPECT_DOUBLE_EQ(index.cast({5.5, 0}, {1, 0}, 10)->range, 0.5);
  EXPECT_DOUBLE_EQ(index.cast({5.5, 0}, {-1, 0}, 10)->range, 0.5);
}

TEST(ShapeIndex, RevisionsTellWhereSomethingChanged) {
  ShapeIndex index;
  const std::uint64_t before = index.revision();
  index.insert(0, Rectangle{{0, 0}, {2, 2}, 0});
  const std::uint64_t after = index.revision();
  EXPECT_TRUE(index.touched_since(before, {3, 0}, 2.01));
  EXPECT_FALSE(index.touched_since(before, {3, 0}, 1.99));
  EXPECT_FALSE(index.touched_since(after, {0, 0}, 100));
  index.remove(0);
  EXPECT_TRUE(index.touched_since(after, {0, 0}, 0.1));
  for (int i = 0; i < 200; ++i) index.insert(0, Disc{{50, 50}, 1}), index.remove(0);
  EXPECT_TRUE(index.touched_since(after, {0, 0}, 0.1)) << "forgotten edits may have touched anything";
}

TEST(ShapeIndex, CopiesAreIndependent) {
  ShapeIndex one;
  one.insert(0, Rectangle{{0, 0}, {2, 2}, 0});
  ShapeIndex two = one;
  two.remove(0);
  EXPECT_TRUE(one.inside({0, 0}));
  EXPECT_FALSE(two.inside({0, 0}));
  one = two;
  EXPECT_EQ(one.wall_count(), 0u);
}

TEST(ShapeIndex, AnEmptyIndexAnswersToo) {
  ShapeIndex index;
  for (int round = 0; round < 2; ++round) {
    EXPECT_FALSE(index.cast({0, 0}, {1, 0}, 1e9));
    EXPECT_FALSE(index.inside({0.5, 0.5}));
    EXPECT_EQ(index.distance({1e300, -5}, 7), 7);

    index.insert(5, Disc{{1, 1}, 1});
    index.clear();
  }
}

TEST(ShapeIndex, MisuseIsAnError) {
  ShapeIndex index;
  index.insert(0, Disc{{0, 0}, 1});
  EXPECT_THROW(index.insert(0, Disc{{0, 0}, 1}), ArgumentError);
  EXPECT_THROW(index.remove(1), ArgumentError);
}

}  // namespace
}  // namespace meander
