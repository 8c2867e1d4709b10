// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_index.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "geometry_brute_force.hpp"

namespace meander {
namespace {

using namespace brute_force;

/// A place where something special happens: on a vertex, an edge, a cell border, or just anywhere.
Vec2 nasty_point(Stream& random, const Shapes& shapes, double reach) {
  const int kind = random.below(5);
  if (kind >= 3 || shapes.empty()) return random_point(random, reach);
  if (kind == 2) return random_point(random, reach).array().round().matrix();
  auto it = shapes.begin();
  std::advance(it, random.below(static_cast<int>(shapes.size())));
  const auto all = edges(it->second);
  if (all.empty()) return std::get<Disc>(it->second).center;
  const auto& [a, b] = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
  return kind == 0 ? a : Vec2(0.5 * (a + b));
}

/// Axis-parallel directions are exact, so that rays run along walls and cell borders.
Vec2 nasty_direction(Stream& random) {
  switch (random.below(6)) {
    case 0:
      return {1, 0};
    case 1:
      return {-1, 0};
    case 2:
      return {0, 1};
    case 3:
      return {0, -1};
    default:
      return direction(random.uniform(-4, 4));
  }
}

/// How many of the questions were no mere "nothing there".
struct Tally {
  int hits = 0, inside = 0, near = 0;
};

/// May the two ranges differ by rounding? A ray that touches a vertex, runs along a wall or ends on one may go either
/// way: then the nearer range must be of a point of some wall, and a ray a nanometre aside must find the other.
bool equal_but_for_touching(const Shapes& shapes, const Vec2& p, const Vec2& u, double most, double found,
                            double expected) {
  if (found == expected || std::abs(found - expected) <= 1e-9) return true;
  const double nearer = std::min(found, expected);
  if (brute_distance(shapes, p + nearer * u, 1) > 1e-9) return false;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const double aside : {-1e-9, 0.0, 1e-9})
    for (const double reach : {most - 1e-9, most, most + 1e-9}) {
      const double range = brute_range(shapes, p + aside * left_of(u), u, reach);
      low = std::min(low, range), high = std::max(high, range);
    }
  return nearer >= low - 1e-6 && std::max(found, expected) <= high + 1e-6;
}

void expect_like_brute_force(const ShapeIndex& index, const Shapes& shapes, Stream& random, double reach, int count,
                             Tally& tally) {
  for (int i = 0; i < count; ++i) {
    const Vec2 p = nasty_point(random, shapes, reach), u = nasty_direction(random);
    const double most = random.chance(0.5) ? random.uniform(0.1, 8) : 10 * reach;
    const auto hit = index.cast(p, u, most);
    const double found = hit ? hit->range : std::numeric_limits<double>::infinity();
    const double expected = brute_range(shapes, p, u, most);
    EXPECT_TRUE(equal_but_for_touching(shapes, p, u, most, found, expected))
        << found << " expected " << expected << " at " << p.transpose() << " along " << u.transpose() << " most "
        << most;
    EXPECT_TRUE(!hit || (hit->point - p - hit->range * u).norm() <= 1e-9);
    const double distance = index.distance(p, most);
    EXPECT_NEAR(distance, brute_distance(shapes, p, most), 1e-9);
    EXPECT_EQ(index.inside(p), brute_inside(shapes, p)) << p.transpose();
    tally.hits += hit.has_value(), tally.near += distance < most, tally.inside += index.inside(p);
  }
}

TEST(ShapeIndex, AnswersLikeBruteForceWhileEdited) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Stream random(seed, "worlds");
    ShapeIndex index(random.uniform(0.3, 5));
    Shapes shapes;
    const double reach = random.uniform(2, 30), size = random.uniform(0.2, 8);
    for (int round = 0; round < 12; ++round) {
      for (int edit = 0; edit < 12; ++edit) {
        const auto owner = static_cast<std::uint32_t>(random.below(40));
        EXPECT_EQ(index.has(owner), shapes.contains(owner));
        if (shapes.contains(owner)) {
          index.remove(owner);
          shapes.erase(owner);
        } else {
          shapes[owner] = random_shape(random, reach, size);
          index.insert(owner, shapes[owner]);
        }
      }
      expect_like_brute_force(index, shapes, random, 1.5 * reach, 60, tally);
    }
  }
  EXPECT_GT(tally.hits, 10000);
  EXPECT_GT(tally.inside, 3000);
  EXPECT_GT(tally.near, 10000);
}

TEST(ShapeIndex, AnswersLikeBruteForceFarFromTheOrigin) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Stream random(seed, "far");
    const Vec2 there(random.uniform(-9e5, 9e5), random.uniform(-9e5, 9e5));
    ShapeIndex index;
    Shapes shapes;
    for (std::uint32_t owner = 0; owner < 20; ++owner) {
      shapes[owner] = moved(random_shape(random, 10, 4), there);
      index.insert(owner, shapes[owner]);
    }
    for (int i = 0; i < 300; ++i) {
      const Vec2 p = there + random_point(random, 15), u = direction(random.uniform(-4, 4));
      const auto hit = index.cast(p, u, 20);
      const double expected = brute_range(shapes, p, u, 20);
      EXPECT_NEAR(hit ? hit->range : 30, std::min(30.0, expected), 1e-6);
      EXPECT_NEAR(index.distance(p, 20), brute_distance(shapes, p, 20), 1e-8);
      EXPECT_EQ(index.inside(p), brute_inside(shapes, p));
    }
  }
}

/// Every piece that touches a disc, in the order of owners and along their borders.
std::vector<Vec2> gathered(const ShapeIndex& index, const Vec2& center, double radius) {
  std::vector<Wall> walls;
  std::vector<Pole> poles;
  index.gather(center, radius, walls, poles);
  std::vector<Vec2> flat;
  for (const Wall& w : walls)
    flat.insert(flat.end(), {w.a, w.b, Vec2(w.owner, w.convex_a + 2 * w.convex_b + 4 * w.solid)});
  for (const Pole& p : poles) flat.insert(flat.end(), {p.disc.center, Vec2(p.owner, p.disc.radius)});
  return flat;
}

TEST(ShapeIndex, GathersEachPieceOnceWhateverTheHistory) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Stream random(seed, "gather");
    Shapes shapes;
    for (std::uint32_t owner = 0; owner < 30; ++owner) shapes[owner] = random_shape(random, 10, 3);
    ShapeIndex straight, troubled(2);
    for (const auto& [owner, shape] : shapes) straight.insert(owner, shape);
    for (int i = 0; i < 300; ++i) {
      const auto owner = static_cast<std::uint32_t>(random.below(30));
      if (troubled.has(owner))
        troubled.remove(owner);
      else
        troubled.insert(owner, random_shape(random, 10, 3));
    }
    for (std::uint32_t owner = 30; owner-- > 0;) {
      if (troubled.has(owner)) troubled.remove(owner);
      troubled.insert(owner, shapes[owner]);
    }
    EXPECT_EQ(troubled.wall_count(), straight.wall_count());
    for (int i = 0; i < 50; ++i) {
      const Vec2 c = random_point(random, 14);
      const double radius = random.uniform(0, 12);
      EXPECT_EQ(gathered(straight, c, radius), gathered(troubled, c, radius));
      std::vector<Wall> walls;
      std::vector<Pole> poles;
      straight.gather(c, radius, walls, poles);
      std::size_t expected = 0, round = 0;
      for (const auto& [owner, shape] : shapes) {
        for (const auto& [a, b] : edges(shape)) expected += distance_to_segment(c, a, b) <= radius;
        if (const auto* disc = std::get_if<Disc>(&shape)) round += (c - disc->center).norm() <= radius + disc->radius;
      }
      EXPECT_EQ(walls.size(), expected);
      EXPECT_EQ(poles.size(), round);
    }
  }
}

/// Every piece has the material of its owner, however many materials came and went.
TEST(ShapeIndex, MaterialsOfReplacedShapesMakeRoomForNewOnes) {
  constexpr int kReplacements = 70000, kOwners = 20;
  Stream random(1, "materials");
  ShapeIndex index;
  Shapes shapes;
  std::map<std::uint32_t, Material> materials;
  for (int i = 0; i < kReplacements; ++i) {
    const auto owner = static_cast<std::uint32_t>(i % kOwners);
    if (index.has(owner)) index.remove(owner);
    shapes[owner] = Disc{random_point(random, 10), 0.3};
    if (i % 3 == 0) shapes[owner] = Rectangle{random_point(random, 10), {0.5, 1}, 0.3};
    materials[owner] = {.echo = static_cast<double>(i / 2) / kReplacements};  // two owners share each
    if (i % 4 == 0) materials[owner].specular_limit = random.uniform(0, 1.5);
    index.insert(owner, shapes[owner], materials[owner]);
  }
  std::vector<Wall> walls;
  std::vector<Pole> poles;
  index.gather({0, 0}, 100, walls, poles);
  EXPECT_FALSE(walls.empty() || poles.empty());
  const auto expect_own = [&](const auto& piece) {
    const Material &found = index.material(piece.material), &own = materials[piece.owner];
    EXPECT_EQ(found.echo, own.echo);
    EXPECT_TRUE(found.specular_limit == own.specular_limit ||
                (std::isnan(found.specular_limit) && std::isnan(own.specular_limit)));
  };
  for (const Wall& wall : walls) expect_own(wall);
  for (const Pole& pole : poles) expect_own(pole);
  Tally tally;
  expect_like_brute_force(index, shapes, random, 12, 300, tally);
  EXPECT_GT(tally.hits, 50);
}

/// The unordered walk meets the pieces that gather() lists, and no others.
TEST(ShapeIndex, WalksAroundThePiecesThatItGathers) {
  Stream random(3, "around");
  ShapeIndex index;
  for (std::uint32_t owner = 0; owner < 40; ++owner) index.insert(owner, random_shape(random, 10, 3));
  for (int i = 0; i < 200; ++i) {
    const Vec2 center = random_point(random, 12);
    const double radius = random.uniform(0, 6);
    std::vector<Wall> walls;
    std::vector<Pole> poles;
    index.gather(center, radius, walls, poles);
    using Ends = std::array<double, 4>;
    const auto ends = [](const Wall& w) { return Ends{w.a.x(), w.a.y(), w.b.x(), w.b.y()}; };
    const auto rim = [](const Disc& d) { return Ends{d.center.x(), d.center.y(), d.radius, 0}; };
    std::set<Ends> listed, met;
    for (const Wall& wall : walls) listed.insert(ends(wall));
    for (const Pole& pole : poles) listed.insert(rim(pole.disc));
    index.around(
        center, radius, [&](const Wall& wall) { met.insert(ends(wall)); },
        [&](const Disc& disc) { met.insert(rim(disc)); });
    EXPECT_EQ(met, listed);
  }
}

TEST(ShapeIndex, WideWorldsTakeCoarserCells) {
  ShapeIndex index;
  Shapes shapes;
  const auto add = [&](const Shape& shape) {
    const auto owner = static_cast<std::uint32_t>(shapes.size());
    index.insert(owner, shape);
    shapes[owner] = shape;
  };
  add(Rectangle{{0, 0}, {1, 1}, 0.4});
  add(Disc{{1e6, -1e6}, 0.5});
  add(Rectangle{{-1e6, 1e6}, {1e6, 1e6}, 1});
  add(Chain{{{-1e6, -1e6}, {1e6, 1e6 - 3}}, false});
  for (int i = 0; i < 50; ++i) add(Chain{{{-1e6, i * 1.0}, {1e6, i * 1.0 + 0.5}}, false});
  Tally tally;
  Stream random(1, "wide");
  for (int i = 0; i < 300; ++i) {
    const Vec2 p = random_point(random, 30), u = direction(random.uniform(-4, 4));
    const auto hit = index.cast(p, u, 1e4);
    EXPECT_NEAR(hit ? hit->range : 0,
                std::min(brute_range(shapes, p, u, 1e4), 1e9) < 1e9 ? brute_range(shapes, p, u, 1e4) : 0, 1e-6);
    EXPECT_NEAR(index.distance(p, 1e7), brute_distance(shapes, p, 1e7), 1e-8);
  }
  EXPECT_TRUE(index.inside({0, 0}));
  EXPECT_TRUE(index.inside({1e6, -1e6 + 0.4}));
  for (std::uint32_t owner = 1; owner < shapes.size(); ++owner) index.remove(owner);
  EXPECT_TRUE(index.inside({0, 0}));
  EXPECT_DOUBLE_EQ(index.distance({10, 0}, 3), 3);
}

}  // namespace
}  // namespace meander
