// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"
#include "indicator/cell_walk.hpp"
#include "indicator/indicator_text.hpp"

namespace meander {
namespace {

constexpr LabyrinthKind kKinds[] = {LabyrinthKind::backtracker, LabyrinthKind::prim, LabyrinthKind::mixed};
constexpr double kLoops[] = {0, 0.05, 0.15};

Labyrinth labyrinth(std::uint64_t seed, LabyrinthKind kind, int size, double loops, int rooms = 0) {
  return make_labyrinth({.seed = seed, .kind = kind, .columns = size, .rows = size, .loops = loops, .rooms = rooms});
}

Explorer explorer(Cell goal, double eps = 0, ExplorerRules rules = ExplorerRules::optimistic,
                  ExplorerKind kind = ExplorerKind::indicator) {
  ExplorerOptions options;
  options.eps = eps;
  options.rules = rules;
  options.explorer = kind;
  return Explorer(cell_center(goal), options);
}

/// Runs until the route is proven, at most `most`; the number of runs, 0: not within.
int runs_to_proof(const Labyrinth& maze, Cell start, Explorer& explorer, int most = 60) {
  for (int run = 1; run <= most; ++run) {
    EXPECT_EQ(walk_cells(maze, start, explorer).ending, Ending::reached);
    if (explorer.proven()) return run;
  }
  return 0;
}

/// No link that was found closed is left: every link can be driven in the labyrinth as it is now.
void expect_links_are_open(const Labyrinth& maze, const IndicatorGraph& graph) {
  for (const Link& link : graph.links()) {
    const Vec2 a = graph.get(link.a.indicator).position, b = graph.get(link.b.indicator).position;
    const Cell from{static_cast<int>(a.x()), static_cast<int>(a.y())},
        to{static_cast<int>(b.x()), static_cast<int>(b.y())};
    const double way = shortest_way(maze, from, to);
    EXPECT_GE(way, 0);
    EXPECT_LE(way, link.length);
  }
}

TEST(Explorer, ReachesEveryGoalAndProvesTheShortestRoute) {
  for (const LabyrinthKind kind : kKinds)
    for (const double loops : kLoops)
      for (const int size : {5, 10, 20})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
          const Labyrinth maze = labyrinth(seed, kind, size, loops);
          const Cell goal{size - 1, size - 1};
          Explorer rules = explorer(goal);
          ASSERT_GT(runs_to_proof(maze, {0, 0}, rules), 0) << to_string(kind) << size << loops << seed;
          const CellWalk last = walk_cells(maze, {0, 0}, rules);
          EXPECT_EQ(last.walked, shortest_way(maze, {0, 0}, goal));
          EXPECT_NEAR(rules.route()->length, last.walked, 1e-9);
        }
}

TEST(Explorer, ExploringAKnownLabyrinthChangesNothing) {
  const Labyrinth maze = labyrinth(3, LabyrinthKind::mixed, 12, 0.1);
  Explorer rules = explorer({11, 11});
  runs_to_proof(maze, {0, 0}, rules);
  const CellWalk once = walk_cells(maze, {0, 0}, rules);
  const std::uint64_t revision = rules.graph().revision();
  const CellWalk again = walk_cells(maze, {0, 0}, rules);
  EXPECT_EQ(rules.graph().revision(), revision);
  EXPECT_EQ(once.visits, again.visits);
}

TEST(Explorer, StatesThatAGoalCannotBeReachedWhenAllIsCovered) {
  for (const LabyrinthKind kind : kKinds)
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Labyrinth maze = labyrinth(seed, kind, 10, 0.1);
      const Cell goal{9, 9};
      for (int side = 2; side < kSides; ++side) maze.set_open(goal, side, false);
      for (const ExplorerKind who : {ExplorerKind::indicator, ExplorerKind::tremaux, ExplorerKind::depth_first,
                                     ExplorerKind::nearest, ExplorerKind::goal_frontier}) {
        Explorer rules = explorer(goal, 0, ExplorerRules::optimistic, who);
        const CellWalk walk = walk_cells(maze, {0, 0}, rules);
        EXPECT_EQ(walk.ending, Ending::no_passable_direction) << to_string(who) << ": " << walk.reason;
        EXPECT_EQ(coverage(maze, {0, 0}, walk), 1) << to_string(who) << seed;
      }
      Explorer repaired = explorer(goal, 0, ExplorerRules::repaired);
      EXPECT_EQ(walk_cells(maze, {0, 0}, repaired).ending, Ending::no_passable_direction);
    }
}

TEST(Explorer, LiteralRulesComeToAStandstillAndRepairedOnesDoNot) {
  int literal = 0, repaired = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Labyrinth maze = labyrinth(seed, LabyrinthKind::mixed, 10, 0);
    Explorer by_letter = explorer({9, 9}, 0, ExplorerRules::literal);
    const CellWalk walk = walk_cells(maze, {0, 0}, by_letter);
    EXPECT_TRUE(walk.ending == Ending::reached || walk.ending == Ending::trapped) << walk.reason;
    literal += walk.ending == Ending::reached;
    Explorer mended = explorer({9, 9}, 0, ExplorerRules::repaired);
    repaired += walk_cells(maze, {0, 0}, mended).ending == Ending::reached;
  }
  EXPECT_LT(literal, 25);
  EXPECT_GT(literal, 2);
  EXPECT_EQ(repaired, 40);
}

TEST(Explorer, BaselinesReachTheGoalToo) {
  for (const ExplorerKind who : {ExplorerKind::tremaux, ExplorerKind::depth_first, ExplorerKind::nearest,
                                 ExplorerKind::goal_frontier, ExplorerKind::random_walk})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Labyrinth maze = labyrinth(seed, LabyrinthKind::mixed, 8, 0.08);
      Explorer rules = explorer({7, 7}, 0, ExplorerRules::optimistic, who);
      const CellWalk walk = walk_cells(maze, {0, 0}, rules);
      EXPECT_EQ(walk.ending, Ending::reached) << to_string(who) << seed << walk.reason;
      EXPECT_EQ(walk.last, (Cell{7, 7}));
    }
}

/// A closed passage on the shortest way that leaves the goal in reach.
std::optional<std::pair<Cell, int>> door_on_the_way(const Labyrinth& maze, Cell goal) {
  const Grid<int> steps = maze.steps_from({0, 0}), rest = maze.steps_from(goal);
  for (int y = 0; y < maze.rows(); ++y)
    for (int x = 0; x < maze.columns(); ++x)
      for (int side = 0; side < kSides; ++side) {
        const Cell cell{x, y}, next = beside(cell, side);
        if (!maze.open(cell, side) || steps[next] != steps[cell] + 1 || steps[cell] + 1 + rest[next] != steps[goal])
          continue;
        Labyrinth closed = maze;
        closed.set_open(cell, side, false);
        if (closed.steps_from({0, 0})[goal] > steps[goal] + 2) return std::pair(cell, side);
      }
  return std::nullopt;
}

TEST(Explorer, FindsRoundADoorThatClosedAndBackWhenItOpens) {
  int doors = 0, back = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Labyrinth maze = labyrinth(seed, LabyrinthKind::mixed, 10, 0.12);
    const Cell goal{9, 9};
    const auto door = door_on_the_way(maze, goal);
    if (!door) continue;
    ++doors;
    Explorer rules = explorer(goal);
    ASSERT_GT(runs_to_proof(maze, {0, 0}, rules), 0);
    const double before = rules.route()->length;
    maze.set_open(door->first, door->second, false);
    const CellWalk first = walk_cells(maze, {0, 0}, rules);
    EXPECT_EQ(first.ending, Ending::reached) << seed << first.reason;
    expect_links_are_open(maze, rules.graph());
    ASSERT_GT(runs_to_proof(maze, {0, 0}, rules), 0) << seed;
    EXPECT_NEAR(rules.route()->length, shortest_way(maze, {0, 0}, goal), 1e-9);
    maze.set_open(door->first, door->second, true);
    for (int run = 0; run < 25; ++run)
      if (walk_cells(maze, {0, 0}, rules).walked == before) {
        ++back;
        break;
      }
  }
  EXPECT_GT(doors, 10);
  EXPECT_EQ(back, doors);
}

TEST(Explorer, EndsForTheBudgetAndTakesNoStepAfterTheEnd) {
  const Labyrinth maze = labyrinth(1, LabyrinthKind::mixed, 15, 0);
  ExplorerOptions options;
  options.budget = 20;
  Explorer rules(cell_center({14, 14}), options);
  const CellWalk walk = walk_cells(maze, {0, 0}, rules);
  EXPECT_EQ(walk.ending, Ending::budget);
  EXPECT_NE(walk.reason.find("20 m"), std::string::npos);
  EXPECT_THROW(rules.step({}), Error);
  options.budget = 0;
  options.decisions = 3;
  Explorer few(cell_center({14, 14}), options);
  EXPECT_EQ(walk_cells(maze, {0, 0}, few).ending, Ending::budget);
}

TEST(Explorer, TheOrderInWhichPortsAreStoredDoesNotMatter) {
  for (const ExplorerKind who : {ExplorerKind::indicator, ExplorerKind::tremaux, ExplorerKind::random_walk})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      Stream random(seed, "order");
      const Labyrinth maze = labyrinth(seed, LabyrinthKind::prim, 8, 0.1);
      Explorer straight = explorer({7, 7}, 0, ExplorerRules::optimistic, who);
      Explorer shuffled = straight;
      straight.begin(), shuffled.begin();
      Percept percept;
      percept.position = cell_center({0, 0});
      // Both are told the same, in another order, as if they were at random crossings of the plane.
      for (int step = 0; step < 60; ++step) {
        percept.ports.clear();
        for (int side = 0; side < kSides; ++side)
          if (step == 0 || random.chance(0.7)) percept.ports.push_back({wrap_angle(side * (kPi / 2)), 1.5});
        Percept other = percept;
        std::reverse(other.ports.begin(), other.ports.end());
        const Decision a = straight.step(percept), b = shuffled.step(other);
        if (step % 3 == 1 && b.ending == Ending::driving)  // nor does writing and reading it on its way
          shuffled = explorer_from_text(to_text(shuffled));
        ASSERT_EQ(a.ending, b.ending);
        ASSERT_EQ(a.direction, b.direction) << seed << " step " << step;
        ASSERT_EQ(a.to, b.to);
        if (a.ending != Ending::driving) break;
        const SinCos way = sin_cos(a.direction);
        percept.position += 1.0 * Vec2(way.cos, way.sin);
        percept.back = wrap_angle(a.direction + kPi);
        percept.walked = 1;
      }
    }
}

TEST(Explorer, ARandomWalkDoesNotDependOnTheOrderInWhichItsLinksAreStored) {
  int nearer = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::vector<Vec2> chosen;
    for (const bool turned : {false, true}) {
      IndicatorGraph graph;
      const IndicatorId here = graph.place({0, 0}), near = graph.place({1, 0}), far = graph.place({2, 0});
      graph.link({here}, {turned ? far : near}, turned ? 2 : 1);
      graph.link({here}, {turned ? near : far}, turned ? 1 : 2);
      ExplorerOptions options;
      options.explorer = ExplorerKind::random_walk;
      options.seed = seed;
      Explorer explorer({9, 9}, options);
      explorer.perceive = [](IndicatorGraph&, IndicatorId) {};
      ExplorerState state;
      state.run = 1;
      state.at = state.start = here;
      explorer.restore(std::move(graph), state);
      const Decision& decision = explorer.step({.position = {0, 0}});
      ASSERT_TRUE(decision.to);
      chosen.push_back(explorer.graph().get(*decision.to).position);
    }
    EXPECT_EQ(chosen[0], chosen[1]) << seed;
    nearer += chosen[0].x() < 1.5;
  }
  EXPECT_GT(nearer, 8);
  EXPECT_LT(nearer, 32);
}

}  // namespace
}  // namespace meander
