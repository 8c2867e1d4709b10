// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "world/rasterize.hpp"

namespace meander {
namespace {

World world_of(const std::vector<Item>& items, const Box& bounds) {
  Header header;
  header.bounds = bounds;
  World world(header);
  for (const Item& item : items) world.add(item);
  return world;
}

Shape random_shape(Stream& stream) {
  const Vec2 at(stream.uniform(1, 9), stream.uniform(1, 9));
  const double size = stream.uniform(0.01, 3);
  switch (stream.below(4)) {
    case 0:
      return Disc{at, size};
    case 1:
      return Rectangle{at, {size, stream.uniform(0.01, 3)}, stream.uniform(-3, 3)};
    case 2:
      return Chain{{at, at + Vec2(stream.normal(), stream.normal()), at + Vec2(stream.normal(), stream.normal())},
                   false};
    default:
      break;
  }
  Polygon star;
  const int count = 3 + stream.below(9);
  for (int i = 0; i < count; ++i) {
    const SinCos t = sin_cos(2 * kPi * i / count);
    star.outer.push_back(at + stream.uniform(0.3, 1) * size * Vec2(t.cos, t.sin));
  }
  return star;
}

TEST(Rasterize, TakesExactlyTheCellsThatAreReached) {
  for (int seed = 0; seed < 120; ++seed) {
    Stream stream(static_cast<std::uint64_t>(seed), "shapes");
    const Shape shape = random_shape(stream);
    if (invalid(shape)) continue;
    const double resolution = stream.uniform(0.1, 0.6);
    const Grid<std::uint8_t> grid = rasterize(world_of({Obstacle{"", shape, {}}}, {{0, 0}, {10, 10}}), resolution);
    for (int y = 0; y < grid.height(); ++y)
      for (int x = 0; x < grid.width(); ++x) {
        const Vec2 center = grid.frame.center({x, y});
        // Sampled: a point of the shape inside the cell proves it reached; the distance of the center can prove it not.
        bool reached = false;
        for (int i = 0; i < 9 && !std::holds_alternative<Chain>(shape); ++i)
          for (int j = 0; j < 9; ++j)
            reached |= contains(shape, Vec2(center + 0.99 * resolution * Vec2(i / 8.0 - 0.5, j / 8.0 - 0.5)));
        const double away = distance(shape, center);
        const bool marked = grid[{x, y}] != 0;
        if (away < 0.499 * resolution) reached = true;
        EXPECT_TRUE(!reached || marked) << "seed " << seed << " cell " << x << ", " << y;
        EXPECT_TRUE(away <= 0.7072 * resolution || !marked) << "seed " << seed << " cell " << x << ", " << y;
      }
  }
}

TEST(Rasterize, GivesBackWholeCells) {
  const World world = world_of({Obstacle{"", Rectangle{{0.5, 0.35}, {0.4, 0.1}, 0}, {}}}, {{0, 0}, {1, 0.7}});
  const Grid<std::uint8_t> grid = rasterize(world, 0.1);
  EXPECT_EQ(grid.width(), 10);
  EXPECT_EQ(grid.height(), 7);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 10; ++x) EXPECT_EQ((grid[{x, y}]), y == 3 && x >= 3 && x < 7) << x << ", " << y;
}

TEST(Rasterize, TakesBothSidesOfAThinWallOnASide) {
  const World world = world_of({Obstacle{"", Chain{{{2, 1.2}, {2, 1.8}}, false}, {}}}, {{0, 0}, {4, 3}});
  EXPECT_EQ(rasterize(world, 1).cells(), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0}));
}

TEST(Rasterize, IsExactForDiscs) {
  const World world = world_of({Obstacle{"", Disc{{1.5, 1.5}, 0.7}, {}}}, {{0, 0}, {3, 3}});
  // The corners of the neighbours across a corner are sqrt(0.5) = 0.707 away.
  EXPECT_EQ(rasterize(world, 1).cells(), (std::vector<std::uint8_t>{0, 1, 0, 1, 1, 1, 0, 1, 0}));
}

TEST(Rasterize, SeesClosedDoorsAndNoMovers) {
  const Shape block = Rectangle{{0.5, 0.5}, {1, 1}, 0};
  const Box bounds{{0, 0}, {2, 1}};
  EXPECT_EQ(rasterize(world_of({Door{"", block, true, {}}}, bounds), 1).cells(), (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(rasterize(world_of({Door{"", block, false, {}}}, bounds), 1).cells(), (std::vector<std::uint8_t>{1, 0}));
  Mover mover;
  mover.disc = {{0.5, 0.5}, 0.3};
  EXPECT_EQ(rasterize(world_of({mover}, bounds), 1).cells(), (std::vector<std::uint8_t>{0, 0}));
}

TEST(Rasterize, KeepsHolesFree) {
  const Polygon frame{{{0, 0}, {5, 0}, {5, 5}, {0, 5}}, {{{1, 1}, {1, 4}, {4, 4}, {4, 1}}}};
  const Grid<std::uint8_t> grid = rasterize(world_of({Obstacle{"", frame, {}}}, {{0, 0}, {5, 5}}), 1);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) EXPECT_EQ((grid[{x, y}]), x == 0 || y == 0 || x == 4 || y == 4);
}

TEST(Rasterize, RefusesWhatIsTooLargeOrNoNumber) {
  const World world;
  EXPECT_THROW(rasterize(world, 0), ArgumentError);
  EXPECT_THROW(rasterize(world, std::nan("")), ArgumentError);
  EXPECT_THROW(rasterize(world, 1e-6), ArgumentError);
  EXPECT_THROW(rasterize(world, 1, {{0, 0}, {std::nan(""), 1}}), ArgumentError);
}

}  // namespace
}  // namespace meander
