// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "planning/neural_map.hpp"
#include "planning/neural_replanner.hpp"
#include "planning_neural_maps.hpp"

namespace meander {
namespace {

using namespace neural_maps;

/// A block of 5 x 5 cells is added or removed, or a door of two cells closed or opened.
std::vector<CellEdit> random_edit(const Grid<std::uint8_t>& map, Cell keep, Stream& random) {
  const int width = random.chance(0.5) ? 5 : 2, height = width == 5 ? 5 : 1;
  const Cell corner{random.below(map.width() - width), random.below(map.height() - height)};
  const bool block = random.chance(0.5);
  std::vector<CellEdit> edits;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (const Cell cell{corner.x + x, corner.y + y}; cell != keep) edits.push_back({cell, block});
  return edits;
}

/// The same cells have a value, and neighbours differ by the same.
void expect_alike(const Grid<double>& a, const Grid<double>& b) {
  double worst = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x + 1 < a.width(); ++x) {
      ASSERT_EQ((a[{x, y}] == kNoValue), (b[{x, y}] == kNoValue)) << x << ' ' << y;
      if (a[{x, y}] == kNoValue || a[{x + 1, y}] == kNoValue) continue;
      const double da = a[{x + 1, y}] - a[{x, y}], db = b[{x + 1, y}] - b[{x, y}];
      if (std::abs(da) < 5) worst = std::max(worst, std::abs(da - db));  // else a wall lies between them
    }
  EXPECT_LT(worst, 1e-4);
}

TEST(NeuralReplanner, EditsGiveWhatASolveFromScratchGives) {
  for (const Lattice lattice : {Lattice::rectangular, Lattice::wide, Lattice::hexagonal})
    for (auto& [name, map] : maps_of_all_kinds(45, 2300)) {
      SCOPED_TRACE(name);
      PlanningProblem problem = problem_on(map, 2301);
      problem.lattice = lattice;
      Stream random(2302, "edits");
      NeuralReplanner replanner(problem);
      for (int i = 0; i < 25; ++i) {
        replanner.edit(random_edit(problem.blocked, problem.targets[0], random));
        const PlanningResult fresh = neural_map(replanner.problem(), {.solver = NeuralSolver::active_list});
        const PlanningResult followed = replanner.landscape();
        EXPECT_LT(followed.statistics.residual, 1e-6);
        EXPECT_EQ(followed.statistics.dead_units, 0);
        expect_alike(followed.value, fresh.value);
      }
    }
}

/// Rooms whose doors open and shut, targets blocked and freed, walls broken: on tiles and held against the active list.
TEST(NeuralReplanner, ManyEditsOnTilesStayExact) {
  for (const Corners corners : {Corners::keep, Corners::cut})
    for (const std::uint64_t seed : {2310, 2311}) {
      PlanningProblem problem = problem_on(rooms(150, 130, 25, seed), seed);
      problem.corners = corners;
      problem.targets.push_back({140, 120});
      Stream random(seed, "edits");
      NeuralReplanner replanner(problem);
      std::int64_t updates = 0, from_scratch = 0;
      for (int i = 0; i < 60; ++i) {
        std::vector<CellEdit> edits = random_edit(problem.blocked, {-1, -1}, random);
        if (i % 5 == 0) edits = {{problem.targets[1], i % 10 == 0}};
        if (i % 5 == 1) edits.assign({{{24, 3 + i}, i % 10 == 1}, {{24, 4 + i}, i % 10 == 1}});
        replanner.edit(edits);
        updates += replanner.last_relaxations();
        const PlanningResult fresh = neural_map(replanner.problem(), {.solver = NeuralSolver::active_list});
        from_scratch += neural_map(replanner.problem()).statistics.relaxations;
        const PlanningResult followed = replanner.landscape();
        EXPECT_LT(followed.statistics.residual, 1e-6);
        EXPECT_EQ(followed.statistics.dead_units, 0);
        EXPECT_EQ(followed.statistics.cells, fresh.statistics.cells);
        expect_alike(followed.value, fresh.value);
      }
      EXPECT_LT(updates, from_scratch / 2);
    }
}

TEST(NeuralReplanner, AfterAStopTheNextEditSolvesAnew) {
  StopToken stop;
  Work work;
  work.stop = &stop;
  const PlanningProblem problem = problem_on(rooms(100, 100, 25, 2320), 2321);
  NeuralReplanner replanner(problem);
  stop.request();
  EXPECT_THROW(replanner.edit(std::vector<CellEdit>{{{50, 50}, true}}, work), Cancelled);
  replanner.edit(std::vector<CellEdit>{{{51, 50}, true}});
  expect_alike(replanner.landscape().value,
               neural_map(replanner.problem(), {.solver = NeuralSolver::active_list}).value);
}

TEST(NeuralReplanner, FarEditsCostLittle) {
  NeuralReplanner replanner({.blocked = open_floor(400, 400), .targets = {{3, 3}}});
  const std::int64_t all = replanner.last_relaxations();
  replanner.edit(std::vector<CellEdit>{{{390, 390}, true}});
  EXPECT_LT(replanner.last_relaxations(), all / 50);
}

TEST(NeuralReplanner, ARegionThatIsCutOffIsEmptyAtOnceAndComesBack) {
  PlanningProblem problem{.blocked = open_floor(60, 40), .targets = {{3, 3}}};
  for (int y = 0; y < 40; ++y) problem.blocked[{30, y}] = y == 20 ? 0 : 1;
  NeuralReplanner replanner(problem);
  const PlanningResult before = replanner.landscape();
  replanner.edit(std::vector<CellEdit>{{{30, 20}, true}});
  EXPECT_EQ(replanner.landscape().statistics.cells, 30 * 40);
  EXPECT_LT(replanner.last_relaxations(), 60 * 40 * 8);
  replanner.edit(std::vector<CellEdit>{{{30, 20}, false}});
  expect_alike(replanner.landscape().value, before.value);
}

TEST(NeuralReplanner, ATargetMayBeBlockedAndFreed) {
  const PlanningProblem problem{.blocked = open_floor(20, 20), .targets = {{3, 3}}};
  NeuralReplanner replanner(problem);
  const PlanningResult before = replanner.landscape();
  replanner.edit(std::vector<CellEdit>{{{3, 3}, true}});
  EXPECT_EQ(replanner.landscape().statistics.cells, 0);
  replanner.edit(std::vector<CellEdit>{{{3, 3}, false}});
  expect_alike(replanner.landscape().value, before.value);
  EXPECT_THROW(replanner.edit(std::vector<CellEdit>{{{20, 3}, true}}), ArgumentError);
}

/// Length of the ascent over best neighbours; -1: it ends before the target.
double ascent(const PlanningProblem& problem, const Grid<double>& value) {
  double length = 0;
  Cell here = *problem.start;
  while (here != problem.targets[0]) {
    Cell best = here;
    double step_length = 0;
    for (const LatticeStep& step : lattice_steps(problem.lattice, here.y)) {
      const Cell next{here.x + step.dx, here.y + step.dy};
      if (open_step(problem.blocked, problem.corners, here, step) && value[next] > value[best])
        best = next, step_length = step.length;
    }
    if (best == here) return -1;
    here = best;
    length += step_length;
  }
  return length;
}

TEST(NeuralMap, WhatTheStartNeedsGivesThePathOfTheWholeMap) {
  std::int64_t partial = 0, whole = 0;
  for (int i = 0; i < 6; ++i)
    for (auto& [name, map] : maps_of_all_kinds(101, 2400 + static_cast<std::uint64_t>(i))) {
      PlanningProblem problem = problem_on(map, 2410 + static_cast<std::uint64_t>(i));
      problem.start = problem_on(map, 2420 + static_cast<std::uint64_t>(i)).targets[0];
      if (!no_path_reason(problem).empty()) continue;
      const PlanningResult full = neural_map(problem, {.solver = NeuralSolver::active_list});
      const PlanningResult part = neural_map(problem, {.extent = NeuralExtent::start});
      EXPECT_FALSE(part.statistics.complete);
      partial += part.statistics.cells, whole += full.statistics.cells;
      const double length = ascent(problem, full.value);
      EXPECT_NEAR(ascent(problem, part.value), length, 0.005 * length) << name;
    }
  EXPECT_LT(partial, whole * 3 / 4);
}

}  // namespace
}  // namespace meander
