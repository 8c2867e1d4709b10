// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/cell_planner.hpp"

#include <gtest/gtest.h>

namespace meander {
namespace {

Labyrinth labyrinth(std::uint64_t seed, int side, double loops) {
  LabyrinthPlan plan;
  plan.seed = seed;
  plan.columns = plan.rows = side;
  plan.loops = loops;
  return make_labyrinth(plan);
}

TEST(CellPlanner, ReachesItsGoalAndEndsWithTheShortestWayProven) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const int side = 3 + static_cast<int>(seed % 12);
    const Labyrinth cells = labyrinth(seed, side, 0.05 * static_cast<double>(seed % 4));
    const Cell goal{side - 1, side - 1};
    CellPlanner planner(side, side, goal);
    int runs = 0;
    do {
      const CellWalk walk = planner.walk(cells, {0, 0});
      ASSERT_EQ(walk.ending, Ending::reached) << seed;
      EXPECT_EQ(walk.last, goal);
      EXPECT_GE(walk.walked, shortest_way(cells, {0, 0}, goal));
      if (planner.proven()) {
        EXPECT_EQ(walk.walked, shortest_way(cells, {0, 0}, goal)) << seed;
      }
    } while (!planner.proven() && ++runs < 200);
    EXPECT_TRUE(planner.proven()) << seed;
  }
}

TEST(CellPlanner, AGoalThatIsWalledInIsGivenUpOnceNoWayCanLeadThere) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Labyrinth cells = labyrinth(seed, 8, 0.1);
    for (int side = 0; side < kSides; ++side)
      if (cells.contains(beside({4, 4}, side))) cells.set_open({4, 4}, side, false);
    CellPlanner planner(8, 8, {4, 4});
    const CellWalk walk = planner.walk(cells, {0, 0});
    EXPECT_EQ(walk.ending, Ending::no_passable_direction);
    EXPECT_FALSE(planner.proven());
  }
}

TEST(CellPlanner, AWallThatGoesIsSeenWhenItIsInSight) {
  Labyrinth cells(3, 2);  // two corridors, joined at both ends; the lower one closed in the middle
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 2; ++y) cells.set_open({x, y}, 0, true);
  for (int x = 0; x < 3; x += 2) cells.set_open({x, 0}, 1, true);
  cells.set_open({1, 0}, 0, false);
  CellPlanner planner(3, 2, {2, 0});
  EXPECT_GE(planner.walk(cells, {0, 0}).walked, 4);
  cells.set_open({1, 0}, 0, true);
  EXPECT_EQ(planner.walk(cells, {0, 0}).walked, 2);
}

TEST(CellPlanner, SizesAndPlacesThatDoNotFitAreRefused) {
  EXPECT_THROW(CellPlanner(3, 3, {3, 0}), ArgumentError);
  CellPlanner planner(3, 3, {2, 2});
  EXPECT_THROW(planner.walk(labyrinth(1, 4, 0), {0, 0}), ArgumentError);
  EXPECT_THROW(planner.walk(labyrinth(1, 3, 0), {3, 0}), ArgumentError);
}

}  // namespace
}  // namespace meander
