// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/trace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/random.hpp"
#include "world_trace_laws.hpp"

namespace meander {
namespace {

/// Rows from the top, '#' solid.
Raster raster(const std::vector<std::string>& rows) {
  Raster grid(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) grid[{x, y}] = rows[rows.size() - 1 - y][x] == '#';
  return grid;
}

Raster noise(std::uint64_t seed, int width, int height, double density) {
  Stream stream(seed, "noise");
  Raster grid(width, height);
  for (auto& cell : grid.cells()) cell = stream.chance(density);
  return grid;
}

/// Perfect maze by random depth-first carving; walls and corridors `thick` cells wide.
Raster maze(std::uint64_t seed, int rooms, int thick) {
  Stream stream(seed, "maze");
  const int side = 2 * rooms + 1;
  Raster plan(side, side, 1);
  std::vector<Cell> stack{{1, 1}};
  plan[{1, 1}] = 0;
  while (!stack.empty()) {
    const Cell at = stack.back();
    std::vector<Cell> ways;
    for (const Cell d : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}})
      if (plan.at({at.x + 2 * d.x, at.y + 2 * d.y}, 0)) ways.push_back(d);
    if (ways.empty()) {
      stack.pop_back();
      continue;
    }
    const Cell d = ways[static_cast<std::size_t>(stream.below(static_cast<int>(ways.size())))];
    plan[{at.x + d.x, at.y + d.y}] = 0;
    plan[{at.x + 2 * d.x, at.y + 2 * d.y}] = 0;
    stack.push_back({at.x + 2 * d.x, at.y + 2 * d.y});
  }
  Raster grid(side * thick, side * thick);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) grid[{x, y}] = plan[{x / thick, y / thick}];
  return grid;
}

/// Cells whose centres lie within `half` of one of many random lines and circles.
Raster strokes(std::uint64_t seed, int size, double half) {
  Stream stream(seed, "strokes");
  Raster grid(size, size);
  for (int i = 0; i < 8; ++i) {
    const bool round = stream.chance(0.3);
    const Vec2 a(stream.uniform(0, size), stream.uniform(0, size)), b(stream.uniform(0, size), stream.uniform(0, size));
    const double radius = stream.uniform(1, size / 3.0);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const Vec2 center(x + 0.5, y + 0.5);
        const double away = round ? std::abs((center - a).norm() - radius) : distance_to_segment(center, a, b);
        if (away < half) grid[{x, y}] = 1;
      }
  }
  return grid;
}

TEST(Trace, KeepsNoiseAtEveryDensity) {
  for (int seed = 0; seed < 60; ++seed)
    for (const double epsilon : {0.0, 0.25, 0.4, 0.49, 0.499})
      expect_faithful(noise(seed, 5 + seed, 40 - seed / 2, 0.05 + 0.015 * seed), {epsilon, 0},
                      fmt::format("noise {} epsilon {}", seed, epsilon));
}

TEST(Trace, KeepsEveryThreeByThreeRaster) {
  for (int bits = 0; bits < 512; ++bits) {
    Raster grid(3, 3);
    for (std::size_t i = 0; i < 9; ++i) grid.cells()[i] = (bits >> i) & 1;
    expect_faithful(grid, {0.4, 0}, fmt::format("bits {}", bits));
    expect_faithful(grid, {0.499, 0}, fmt::format("bits {}", bits));
  }
}

TEST(Trace, KeepsMazes) {
  for (int seed = 0; seed < 10; ++seed)
    for (const int thick : {1, 2, 3}) expect_faithful(maze(seed, 8, thick), {}, fmt::format("maze {} {}", seed, thick));
}

TEST(Trace, KeepsSlantedAndRoundWalls) {
  for (int seed = 0; seed < 40; ++seed)
    for (const double half : {0.36, 0.5, 0.71, 2.0})
      expect_faithful(strokes(seed, 60, half), {0.1 * (seed % 5), 0}, fmt::format("strokes {} {}", seed, half));
}

TEST(Trace, DoesNotLeak) {
  for (int seed = 0; seed < 15; ++seed) {
    expect_no_leak(noise(seed, 40, 30, 0.2 + 0.04 * seed), {0.49, 0}, fmt::format("noise {}", seed));
    expect_no_leak(maze(seed, 6, 1 + seed % 3), {}, fmt::format("maze {}", seed));
    expect_no_leak(strokes(seed, 60, 0.36), {}, fmt::format("strokes {}", seed));
  }
}

TEST(Trace, JoinsACheckerboardIntoOneSolid) {
  Raster grid(12, 9);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 12; ++x) grid[{x, y}] = (x + y) % 2 == 0;
  expect_faithful(grid, {}, "checkerboard");
  EXPECT_EQ(trace(grid).solids.size(), 1u);
}

TEST(Trace, TracesEmptyAndFullRasters) {
  EXPECT_TRUE(trace(Raster()).solids.empty());
  EXPECT_TRUE(trace(Raster(7, 5)).solids.empty());
  const Traced full = trace(Raster(7, 5, 255));
  ASSERT_EQ(full.solids.size(), 1u);
  EXPECT_EQ(full.solids[0].outer, (std::vector<Vec2>{{0, 0}, {7, 0}, {7, 5}, {0, 5}}));
}

TEST(Trace, KeepsRightAnglesExactly) {
  const Traced traced = trace(raster({"...........",  //
                                      ".#########.",  //
                                      ".#.......#.",  //
                                      ".#.##..#.#.",  //
                                      ".#.##....#.",  //
                                      ".#.......#.",  //
                                      ".#########.",  //
                                      "..........."}));
  ASSERT_EQ(traced.solids.size(), 3u);
  EXPECT_EQ(traced.solids[0].outer, (std::vector<Vec2>{{1, 1}, {10, 1}, {10, 7}, {1, 7}}));
  EXPECT_EQ(traced.solids[0].holes[0].size(), 4u);
  EXPECT_EQ(traced.solids[1].outer, (std::vector<Vec2>{{3, 3}, {5, 3}, {5, 5}, {3, 5}}));
  EXPECT_EQ(traced.solids[2].outer.size(), 4u);  // a single cell stays a square
}

TEST(Trace, DrawsSlantedWallsWithFewEdges) {
  for (const double slope : {0.017, 0.1234, 0.3, 0.3333}) {
    Raster grid(400, 300);
    for (int x = 10; x < 390; ++x)
      for (int y = 20; y < 300; ++y) grid[{x, y}] = y + 0.5 < 60 + slope * x;
    const Traced traced = trace(grid, {0.499, 0});
    ASSERT_EQ(traced.solids.size(), 1u);
    EXPECT_LE(traced.edges, 12u) << slope;
    EXPECT_LT(trace(grid).edges, trace(grid, {0, 0}).edges) << slope;
  }
}

TEST(Trace, HonoursTheFrame) {
  Raster grid(4, 3, 1);
  grid.frame = {0.5, {10, 20, kPi / 2}};
  const Traced traced = trace(grid);
  const std::vector<Vec2> expected{{10, 20}, {10, 22}, {8.5, 22}, {8.5, 20}};
  ASSERT_EQ(traced.solids[0].outer.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((traced.solids[0].outer[i] - expected[i]).norm(), 1e-12);
}

TEST(Trace, DropsSpecksByAreaAndCountsThem) {
  Raster grid = raster({"#....##..",  //
                        ".....##..",  //
                        "..#......",  //
                        "...#....#"});
  grid.frame.resolution = 0.1;
  EXPECT_EQ(trace(grid, {0.4, 0.01}).specks, 0);
  const Traced traced = trace(grid, {0.4, 0.02});
  EXPECT_EQ(traced.specks, 2);  // the two cells that touch in a corner are one patch of 0.02 m^2
  EXPECT_EQ(traced.solids.size(), 2u);
  EXPECT_EQ(trace(grid, {0.4, 1}).specks, 4);
}

TEST(Trace, RefusesOptionsOutOfRange) {
  EXPECT_THROW(trace(Raster(2, 2), {0.5, 0}), ArgumentError);
  EXPECT_THROW(trace(Raster(2, 2), {0.4, -1}), ArgumentError);
}

TEST(Trace, CanBeStopped) {
  StopToken stop;
  stop.request();
  Work work;
  work.stop = &stop;
  EXPECT_THROW(trace(Raster(2, 2), {}, work), Cancelled);
}

}  // namespace
}  // namespace meander
