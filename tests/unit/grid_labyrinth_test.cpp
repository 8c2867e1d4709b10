// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/labyrinth.hpp"

#include <gtest/gtest.h>

namespace meander {
namespace {

int passages(const Labyrinth& labyrinth) {
  int ways = 0;
  for (int y = 0; y < labyrinth.rows(); ++y)
    for (int x = 0; x < labyrinth.columns(); ++x) ways += labyrinth.ways({x, y});
  return ways / 2;
}

TEST(Labyrinth, IsATreeWithoutLoopsAndConnectedWithThem) {
  for (const LabyrinthKind kind : {LabyrinthKind::backtracker, LabyrinthKind::prim, LabyrinthKind::mixed})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      LabyrinthPlan plan{.seed = seed, .kind = kind, .columns = 13, .rows = 9};
      const Labyrinth tree = make_labyrinth(plan);
      EXPECT_EQ(passages(tree), 13 * 9 - 1);
      EXPECT_EQ(tree, make_labyrinth(plan));
      const Grid<int> steps = tree.steps_from({5, 5});
      for (const int count : steps.cells()) EXPECT_GE(count, 0);
      plan.loops = 0.2;
      const Labyrinth net = make_labyrinth(plan);
      EXPECT_GT(passages(net), passages(tree));
      plan.loops = 0;
      plan.rooms = 4;
      EXPECT_GT(passages(make_labyrinth(plan)), passages(tree));
      for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 13; ++x)
          for (int side = 0; side < kSides; ++side) {
            if (!tree.open({x, y}, side)) continue;
            EXPECT_TRUE(tree.open(beside({x, y}, side), opposite(side)));
            EXPECT_TRUE(net.open({x, y}, side));  // loops only take walls away
          }
    }
}

TEST(Labyrinth, KindsDifferInTheirCorridors) {
  const auto dead_ends = [](LabyrinthKind kind) {
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Labyrinth l = make_labyrinth({.seed = seed, .kind = kind, .columns = 20, .rows = 20});
      for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) count += l.ways({x, y}) == 1;
    }
    return count;
  };
  EXPECT_LT(1.5 * dead_ends(LabyrinthKind::backtracker), dead_ends(LabyrinthKind::mixed));
  EXPECT_LT(dead_ends(LabyrinthKind::mixed), dead_ends(LabyrinthKind::prim));
}

TEST(Labyrinth, RefusesWhatMakesNoSense) {
  EXPECT_THROW(Labyrinth(0, 3), ArgumentError);
  EXPECT_THROW(make_labyrinth({.columns = 1000}), ArgumentError);
  Labyrinth one(1, 1);
  EXPECT_EQ(one.ways({0, 0}), 0);
  EXPECT_THROW(one.set_open({0, 0}, 0, true), ArgumentError);
  EXPECT_THROW(one.steps_from({1, 0}), ArgumentError);
  EXPECT_EQ(make_labyrinth({.columns = 1, .rows = 1, .rooms = 3}), one);
}

}  // namespace
}  // namespace meander
