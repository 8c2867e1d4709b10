// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// D* Lite against a search from scratch, while the start moves and cells change.
#include "indicator/dstar_lite.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "indicator/geodesic_field.hpp"

namespace meander {
namespace {

/// Length of the shortest way [cells] by a search that knows nothing of what was.
double from_scratch(const DStarLite& planner, Cell start, Cell goal) {
  ConfigurationSpace space(planner.width(), planner.height(), {}, 0);
  for (int y = 0; y < planner.height(); ++y)
    for (int x = 0; x < planner.width(); ++x) space.set({x, y}, planner.blocked({x, y}) ? Known::wall : Known::free);
  GeodesicField field;
  field.spread(space, goal, 1e6);
  return field.at(start);
}

/// Length of a way, or -1 when a step of it is none.
double walked(const DStarLite& planner, const std::vector<Cell>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const int dx = way[i].x - way[i - 1].x, dy = way[i].y - way[i - 1].y;
    const bool corner = planner.blocked({way[i - 1].x, way[i].y}) || planner.blocked({way[i].x, way[i - 1].y});
    if (std::abs(dx) > 1 || std::abs(dy) > 1 || planner.blocked(way[i]) || (dx * dy != 0 && corner)) return -1;
    length += dx * dy != 0 ? 1.4 : 1;
  }
  return length;
}

TEST(DStarLite, StaysAsShortAsASearchFromScratchWhileTheStartMovesAndCellsChange) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Stream random(seed, "dstar");
    const int width = 5 + random.below(25), height = 5 + random.below(25);
    const auto anywhere = [&] {
      const int x = random.below(width);
      return Cell{x, random.below(height)};
    };
    const Cell goal = anywhere();
    Cell start = anywhere();
    DStarLite planner(width, height, goal);
    for (int i = 0; i < width * height / 3; ++i) planner.set_blocked(anywhere(), true);
    planner.set_blocked(goal, false);
    for (int step = 0; step < 60; ++step) {
      planner.set_blocked(start, false);
      const std::vector<Cell> way = planner.plan(start);
      const double exact = from_scratch(planner, start, goal);
      ASSERT_EQ(way.empty(), !std::isfinite(exact)) << "seed " << seed << ", step " << step;
      if (!way.empty()) {
        EXPECT_EQ(way.front(), start);
        EXPECT_EQ(way.back(), goal);
        ASSERT_NEAR(planner.length(), exact, 1e-9) << "seed " << seed << ", step " << step;
        ASSERT_NEAR(walked(planner, way), exact, 1e-9);
        start = way[std::min(way.size() - 1, static_cast<std::size_t>(random.below(4)))];
      }
      if (step % 20 == 19) start = anywhere();  // set down elsewhere
      for (int i = 0; i < 4; ++i) planner.set_blocked(anywhere(), random.below(2) == 0);
      planner.set_blocked(goal, false);
    }
  }
}

TEST(DStarLite, OnTheWayThroughWhatItDoesNotKnowAPlanCostsFarLessThanASearchOfTheMap) {
  const int side = 150;
  const Cell goal{side - 2, side - 2};
  Stream random(7, "dstar");
  Grid<std::uint8_t> truth(side, side);
  for (std::uint8_t& cell : truth.cells()) cell = random.chance(0.25);
  Cell at{1, 1};
  truth[at] = truth[goal] = 0;
  DStarLite planner(side, side, goal);
  int plans = 0;
  while (!(at == goal)) {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        planner.set_blocked({at.x + dx, at.y + dy}, truth.at({at.x + dx, at.y + dy}, 1) != 0);
    const std::vector<Cell>& way = planner.plan(at);
    ++plans;
    ASSERT_GE(way.size(), 2u);
    at = way[1];
  }
  EXPECT_GT(plans, side);
  EXPECT_LT(planner.expanded(), static_cast<std::uint64_t>(plans) * side * side / 100);
}

TEST(DStarLite, WithoutDiagonalStepsWaysAreCornered) {
  DStarLite planner(10, 10, {9, 9}, false);
  EXPECT_EQ(planner.plan({0, 0}).size(), 19u);
  EXPECT_NEAR(planner.length(), 18, 1e-9);
}

TEST(DStarLite, PlacesThatCannotBe) {
  EXPECT_THROW(DStarLite(4, 4, {4, 0}), ArgumentError);
  DStarLite planner(4, 4, {3, 3});
  EXPECT_TRUE(planner.plan({-1, 0}).empty());
  planner.set_blocked({3, 3}, true);
  EXPECT_TRUE(planner.plan({0, 0}).empty());
  EXPECT_FALSE(std::isfinite(planner.length()));
  planner.set_blocked({3, 3}, false);
  EXPECT_EQ(planner.plan({0, 0}).size(), 4u);
}

}  // namespace
}  // namespace meander
