// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <set>

#include "base/random.hpp"
#include "geometry/segment.hpp"
#include "grid/flood.hpp"
#include "grid/inflation.hpp"
#include "grid/traversal.hpp"

namespace meander {
namespace {

Grid<std::uint8_t> random_grid(Stream& random, double share) {
  Grid<std::uint8_t> grid(1 + random.below(40), 1 + random.below(40), 0, {0.25, {3, -2, 0.4}});
  for (std::uint8_t& cell : grid.cells()) cell = random.chance(share);
  return grid;
}

GridFrame random_frame(Stream& random) {
  return {random.uniform(0.01, 3), {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-4, 4)}};
}

TEST(GridFrame, CellsAndCentresAgree) {
  Stream random(1, "frame");
  for (int i = 0; i < 2000; ++i) {
    const GridFrame frame = random_frame(random);
    const Cell cell{random.below(2000) - 1000, random.below(2000) - 1000};
    EXPECT_EQ(frame.cell(frame.center(cell)), cell);
    const Vec2 p(random.uniform(-50, 50), random.uniform(-50, 50));
    EXPECT_LE((frame.center(frame.cell(p)) - p).norm(), frame.resolution * std::sqrt(0.5) + 1e-9);
  }
  EXPECT_EQ(GridFrame{}.cell({-0.5, 3.5}), (Cell{-1, 3}));
  EXPECT_GT(GridFrame{}.cell({1e300, 0}).x, 1'000'000);
}

TEST(Grid, KnowsItsRim) {
  Grid<int> grid(3, 2, 7);
  EXPECT_TRUE(grid.contains({2, 1}));
  EXPECT_FALSE(grid.contains({3, 1}));
  EXPECT_FALSE(grid.contains({0, -1}));
  grid[{1, 1}] = 5;
  EXPECT_EQ(grid.at({1, 1}, 0), 5);
  EXPECT_EQ(grid.at({-1, 1}, 9), 9);
  EXPECT_EQ(grid.cells()[4], 5) << "rows follow each other, the bottom row first";
  EXPECT_THROW(Grid<int>(-1, 2), ArgumentError);
}

/// Does the segment pass the inside of the square (x, y) .. (x + 1, y + 1), made smaller by `less` on every side?
bool passes(const Vec2& from, const Vec2& to, Cell cell, double less) {
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = (axis ? cell.y : cell.x) + less, high = (axis ? cell.y : cell.x) + 1 - less;
    const double d = to[axis] - from[axis];
    if (d == 0 && (from[axis] < low || from[axis] > high)) return false;
    if (d == 0) continue;
    enter = std::max(enter, std::min((low - from[axis]) / d, (high - from[axis]) / d));
    leave = std::min(leave, std::max((low - from[axis]) / d, (high - from[axis]) / d));
  }
  return enter <= leave;
}

TEST(Traversal, VisitsExactlyTheCellsOnTheWay) {
  Stream random(2, "traversal");
  for (int i = 0; i < 3000; ++i) {
    const GridFrame frame = i % 2 ? random_frame(random) : GridFrame{};
    Vec2 a(random.uniform(-8, 8), random.uniform(-8, 8)), b(random.uniform(-8, 8), random.uniform(-8, 8));
    if (i % 5 == 0) a = a.array().round(), b = b.array().round();
    const Vec2 from = frame.origin * Vec2(a * frame.resolution), to = frame.origin * Vec2(b * frame.resolution);
    std::vector<Cell> cells;
    EXPECT_TRUE(traverse(frame, from, to, [&](Cell cell) { return cells.push_back(cell), true; }));
    EXPECT_EQ(cells.front(), frame.cell(from));
    EXPECT_EQ(cells.back(), frame.cell(to));
    std::set<std::pair<int, int>> visited;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      EXPECT_TRUE(visited.insert({cells[k].x, cells[k].y}).second) << "none twice";
      EXPECT_TRUE(passes(a, b, cells[k], -1e-9)) << "none beside the way";
      if (k > 0) {
        EXPECT_LE(std::abs(cells[k].x - cells[k - 1].x), 1);
        EXPECT_LE(std::abs(cells[k].y - cells[k - 1].y), 1);
      }
    }
    for (int y = -10; y < 10; ++y)
      for (int x = -10; x < 10; ++x)
        EXPECT_TRUE(!passes(a, b, {x, y}, 1e-9) || visited.contains({x, y})) << "none left out";
  }
}

TEST(Traversal, GoesDiagonallyThroughCornersAndStopsWhenAsked) {
  std::vector<Cell> cells;
  const auto take = [&](Cell cell) { return cells.push_back(cell), cells.size() < 3; };
  EXPECT_FALSE(traverse({}, {0.5, 0.5}, {4.5, 4.5}, take));
  EXPECT_EQ(cells, (std::vector<Cell>{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(Inflation, IsTheDistanceToTheNearestOccupiedCentre) {
  Stream random(3, "inflation");
  for (int i = 0; i < 200; ++i) {
    const Grid<std::uint8_t> grid = random_grid(random, random.uniform(0, 0.2));
    const Grid<std::int32_t> squared = squared_distance_cells(grid);
    const double radius = random.uniform(0, 3);
    const Grid<std::uint8_t> fat = inflated(grid, radius);
    for (int y = 0; y < grid.height(); ++y)
      for (int x = 0; x < grid.width(); ++x) {
        std::int32_t best = kNothingNear;
        for (int v = 0; v < grid.height(); ++v)
          for (int u = 0; u < grid.width(); ++u)
            if (grid[{u, v}]) best = std::min(best, (u - x) * (u - x) + (v - y) * (v - y));
        ASSERT_EQ((squared[{x, y}]), best);
        ASSERT_EQ((fat[{x, y}]), best != kNothingNear && std::sqrt(best) * 0.25 <= radius);
      }
    EXPECT_EQ(fat.frame, grid.frame);
  }
}

TEST(Flood, AreasAreConnectedAndApart) {
  Stream random(4, "flood");
  for (int i = 0; i < 200; ++i) {
    const Grid<std::uint8_t> grid = random_grid(random, random.uniform(0.3, 0.8));
    for (const Neighbours neighbours : {Neighbours::four, Neighbours::eight}) {
      const Components found = components(grid, neighbours);
      std::vector<std::size_t> count(found.cells.size());
      std::int32_t next = 0;
      for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
          const std::int32_t label = found.label[{x, y}];
          ASSERT_EQ(label >= 0, (grid[{x, y}] != 0));
          if (label < 0) continue;
          ASSERT_LE(label, next) << "numbered by their first cell";
          next = std::max(next, label + 1);
          ++count[static_cast<std::size_t>(label)];
          for (const Cell& step : {Cell{1, 0}, Cell{0, 1}, Cell{1, 1}, Cell{-1, 1}}) {
            const Cell other{x + step.x, y + step.y};
            const bool adjacent = neighbours == Neighbours::eight || step.x * step.y == 0;
            ASSERT_TRUE(!adjacent || !grid.contains(other) || !grid[other] || found.label[other] == label);
          }
        }
      EXPECT_EQ(count, found.cells);
    }
  }
}

TEST(Flood, AWallSeparates) {
  Grid<std::uint8_t> grid(5, 5, 1);
  for (int i = 0; i < 5; ++i) grid[{i, i}] = 0;
  EXPECT_EQ(components(grid, Neighbours::four).cells, (std::vector<std::size_t>{10, 10}));
  grid[{2, 2}] = 1;
  EXPECT_EQ(components(grid, Neighbours::four).cells, (std::vector<std::size_t>{21}));
}

}  // namespace
}  // namespace meander
