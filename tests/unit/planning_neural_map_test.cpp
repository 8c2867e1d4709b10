// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planning/neural_solution.hpp"
#include "planning_neural_maps.hpp"
#include "planning_neural_reference.hpp"

namespace meander {
namespace {

using namespace neural_maps;

constexpr NeuralSolver kSolvers[] = {NeuralSolver::tiles, NeuralSolver::active_list, NeuralSolver::raster,
                                     NeuralSolver::synchronous};

PlanningResult solved(const PlanningProblem& problem, NeuralSolver solver, double steepness = 0.68) {
  return neural_map(problem, {.solver = solver, .steepness = steepness});
}

/// Each unit's equation, evaluated from the landscape alone in long double.
double worst_residual(const PlanningProblem& problem, const Grid<double>& value, double steepness) {
  double most = 0, worst = 0;
  const auto visit = [&](Cell cell, auto each) {
    if (problem.blocked[cell] != 0) return;
    for (const LatticeStep& step : lattice_steps(problem.lattice, cell.y))
      if (open_step(problem.blocked, problem.corners, cell, step))
        each(Cell{cell.x + step.dx, cell.y + step.dy}, 1 / step_cost(problem, cell, step));
  };
  const auto for_each = [&](auto each) {
    for (int y = 0; y < value.height(); ++y)
      for (int x = 0; x < value.width(); ++x) each(Cell{x, y});
  };
  for (const LatticeStep& step : lattice_steps(problem.lattice)) most += 1 / step.length;
  if (!problem.even()) {
    most = 0;
    for_each([&](Cell cell) {
      double sum = 0;
      visit(cell, [&](Cell, double w) { sum += w; });
      most = std::max(most, sum);
    });
  }
  for_each([&](Cell cell) {
    if (value[cell] == kNoValue || value[cell] == 0) return;
    long double sum = 0;  // relative to the unit's own activation
    visit(cell, [&](Cell next, double w) { sum += w * std::exp(static_cast<long double>(value[next] - value[cell])); });
    sum *= steepness / most;
    const long double own = std::exp(static_cast<long double>(value[cell]));
    if (own > 1e-7L) sum = std::tanh(sum * own) / own;
    worst = std::max(worst, static_cast<double>(std::abs(1 / sum - 1)));
  });
  return worst;
}

/// Largest difference between what the landscapes say about the way from a cell to its neighbours.
double worst_difference(const PlanningProblem& problem, const Grid<double>& a, const Grid<double>& b) {
  double worst = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      EXPECT_EQ((a[{x, y}] == kNoValue), (b[{x, y}] == kNoValue)) << x << ' ' << y;
      if (a[{x, y}] == kNoValue || b[{x, y}] == kNoValue) continue;
      for (const LatticeStep& step : lattice_steps(problem.lattice, y)) {
        const Cell next{x + step.dx, y + step.dy};
        if (!open_step(problem.blocked, problem.corners, {x, y}, step)) continue;
        worst = std::max(worst, std::abs((a[next] - a[{x, y}]) - (b[next] - b[{x, y}])));
      }
    }
  return worst;
}

TEST(NeuralMap, EverySolverFindsTheSameEquilibrium) {
  for (const Corners corners : {Corners::keep, Corners::cut})
    for (auto& [name, map] : maps_of_all_kinds(47, 3)) {
      PlanningProblem problem = problem_on(map, 5);
      problem.corners = corners;
      const PlanningResult reference = solved(problem, NeuralSolver::active_list);
      EXPECT_LT(worst_residual(problem, reference.value, 0.68), 1e-6) << name;
      for (const NeuralSolver solver : kSolvers) {
        const PlanningResult result = solved(problem, solver);
        EXPECT_LT(result.statistics.residual, 1e-6);
        EXPECT_EQ(result.statistics.dead_units, 0);
        EXPECT_TRUE(result.statistics.complete);
        EXPECT_LT(worst_residual(problem, result.value, 0.68), 1e-6) << name << ' ' << to_string(solver);
        EXPECT_LT(worst_difference(problem, reference.value, result.value), 5e-6) << name << ' ' << to_string(solver);
      }
    }
}

TEST(NeuralMap, EverySteepnessAndLatticeConverges) {
  for (const double steepness : {0.35, 0.5, 0.8, 0.9})
    for (const Lattice lattice : {Lattice::rectangular, Lattice::wide, Lattice::hexagonal})
      for (auto& [name, map] : maps_of_all_kinds(32, 4)) {
        PlanningProblem problem = problem_on(map, 6);
        problem.lattice = lattice;
        const PlanningResult result = solved(problem, NeuralSolver::tiles, steepness);
        EXPECT_LT(worst_residual(problem, result.value, steepness), 1e-6) << name << ' ' << to_string(lattice);
        EXPECT_EQ(result.statistics.dead_units, 0);
      }
}

TEST(NeuralMap, HardAndOneSidedWaysConverge) {
  Stream random(9, "terrain");
  for (const Lattice lattice : {Lattice::rectangular, Lattice::wide, Lattice::hexagonal})
    for (auto& [name, map] : maps_of_all_kinds(32, 4)) {
      PlanningProblem problem = problem_on(map, 6);
      problem.lattice = lattice;
      problem.difficulty = Grid<float>(map.width(), map.height());
      for (float& hard : problem.difficulty.cells()) hard = static_cast<float>(random.uniform(0.5, 20));
      problem.drag = Grid<Eigen::Vector2f>(map.width(), map.height(), Eigen::Vector2f(0.5F, -0.6F));
      const PlanningResult result = solved(problem, NeuralSolver::tiles);
      EXPECT_LT(worst_residual(problem, result.value, 0.68), 1e-6) << name << ' ' << to_string(lattice);
      EXPECT_EQ(result.statistics.dead_units, 0);
    }
}

TEST(NeuralMap, GaussianWeightsConverge) {
  for (auto& [name, map] : maps_of_all_kinds(40, 4)) {
    const PlanningProblem problem = problem_on(map, 6);
    const PlanningResult result = neural_map(problem, {.weights = WeightLaw::gaussian, .gamma = 1.5});
    EXPECT_EQ(result.statistics.dead_units, 0) << name;
    EXPECT_LT(result.statistics.residual, 1e-6) << name;
  }
}

/// Free cells that can be reached all have a value, and one of their neighbours has more.
void expect_ways_everywhere(const PlanningProblem& problem, const PlanningResult& result, const std::string& name) {
  const Grid<std::uint8_t> reachable = reachable_cells(problem);
  std::size_t dead = 0, wrong = 0;
  for (int y = 0; y < reachable.height(); ++y)
    for (int x = 0; x < reachable.width(); ++x) {
      const double own = result.value[{x, y}];
      wrong += (reachable[{x, y}] != 0) != (own != kNoValue) ? 1 : 0;
      if (own == kNoValue || own == 0) continue;
      bool higher = false;
      for (const LatticeStep& step : lattice_steps(problem.lattice, y))
        higher = higher || (open_step(problem.blocked, problem.corners, {x, y}, step) &&
                            result.value[{x + step.dx, y + step.dy}] > own);
      dead += higher ? 0 : 1;
    }
  EXPECT_EQ(wrong, 0U) << name;
  EXPECT_EQ(dead, 0U) << name;
  EXPECT_EQ(result.statistics.dead_units, 0) << name;
}

TEST(NeuralMap, NoUnitIsDeadWhereDoublesUnderflow) {
  const NamedMap maps[] = {{"the paper's largest map", open_floor(1000, 500)},
                           {"serpentine", serpentine(200, 200, 5)},
                           {"narrow serpentine", serpentine(200, 200, 1)},
                           {"maze", perfect_maze(201, 201, 2)},
                           {"rooms", rooms(300, 300, 25, 2)},
                           {"clutter", clutter(200, 200, 0.38, 2)}};
  for (const NeuralSolver solver : {NeuralSolver::tiles, NeuralSolver::active_list})
    for (const auto& [name, map] : maps) {
      PlanningProblem problem{.blocked = map, .targets = {{1, 1}}};
      problem.blocked[{1, 1}] = 0;
      expect_ways_everywhere(problem, solved(problem, solver), name);
    }
}

TEST(NeuralMap, SeveralTargetsShareTheMap) {
  for (const NeuralSolver solver : kSolvers) {
    PlanningProblem problem{.blocked = open_floor(41, 41), .targets = {{3, 3}, {36, 5}, {20, 38}, {20, 38}}};
    const PlanningResult result = solved(problem, solver);
    for (const Cell target : problem.targets) EXPECT_EQ(result.value[target], 0);
    expect_ways_everywhere(problem, result, to_string(solver));
  }
}

TEST(NeuralMap, TinyMapsWork) {
  for (const NeuralSolver solver : kSolvers) {
    EXPECT_EQ(solved({.blocked = open_floor(1, 1), .targets = {{0, 0}}}, solver).statistics.cells, 1);
    EXPECT_EQ(solved({.blocked = open_floor(1, 40), .targets = {{0, 3}}}, solver).statistics.cells, 40);
    EXPECT_EQ(solved({.blocked = open_floor(40, 1), .targets = {{39, 0}}}, solver).statistics.cells, 40);
    EXPECT_EQ(solved({.blocked = Map(3, 3, 1), .targets = {{1, 1}}}, solver).reason,
              "the target in cell (1, 1) at (1.50, 1.50) m lies in a wall");
  }
}

TEST(NeuralMap, EarlyTerminationStillLeadsToTheTarget) {
  for (const NeuralSolver solver : {NeuralSolver::raster, NeuralSolver::synchronous}) {
    PlanningProblem problem{.blocked = rooms(60, 60, 15, 7), .targets = {{2, 2}}, .start = Cell{55, 55}};
    const PlanningResult full = solved(problem, solver);
    const PlanningResult early = neural_map(problem, {.solver = solver, .extent = NeuralExtent::start});
    EXPECT_FALSE(early.statistics.complete);
    EXPECT_LT(early.statistics.relaxations, full.statistics.relaxations);
    Cell here = *problem.start;
    for (int i = 0; i < 1000 && here != problem.targets[0]; ++i) {
      Cell best = here;
      for (const LatticeStep& step : lattice_steps(problem.lattice, here.y))
        if (const Cell next{here.x + step.dx, here.y + step.dy};
            open_step(problem.blocked, problem.corners, here, step) && early.value[next] > early.value[best])
          best = next;
      ASSERT_NE(best, here);
      here = best;
    }
    EXPECT_EQ(here, problem.targets[0]);
  }
}

TEST(NeuralMap, AStopEndsASolve) {
  StopToken stop;
  stop.request();
  Work work;
  work.stop = &stop;
  const PlanningProblem problem{.blocked = open_floor(200, 200), .targets = {{3, 3}}};
  for (const NeuralSolver solver : kSolvers) EXPECT_THROW(neural_map(problem, {.solver = solver}, work), Cancelled);
}

/// The neighbour of most activation, in [begin, end) of the lattice's steps.
template <class Value>
Cell best_neighbour(const PlanningProblem& problem, const Grid<Value>& value, Cell cell) {
  Cell best = cell;
  for (const LatticeStep& step : lattice_steps(problem.lattice, cell.y)) {
    const Cell next{cell.x + step.dx, cell.y + step.dy};
    if (open_step(problem.blocked, problem.corners, cell, step) && value[next] > value[best]) best = next;
  }
  return best;
}

/// Units whose best neighbour is another than in the multi-precision solve. Two neighbours that differ by less than
/// 1e-12 there are alike: mirrored ways.
std::size_t wrong_directions(const PlanningProblem& problem, const Grid<neural_reference::Wide>& truth,
                             const PlanningResult& result) {
  std::size_t wrong = 0;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      if (truth[{x, y}] == 0) continue;
      const Cell ours = best_neighbour(problem, result.value, {x, y}), best = best_neighbour(problem, truth, {x, y});
      wrong += truth[best] - truth[ours] > neural_reference::Wide(1e-12) * truth[best] ? 1 : 0;
    }
  return wrong;
}

TEST(NeuralMap, TheSteepestNeighbourIsThatOfAMultiPrecisionSolveInEveryUnit) {
  const double beta = 0.68 / (4 + 4 / std::sqrt(2.0));
  std::vector<NamedMap> maps;
  for (int i = 0; i < 4; ++i)
    for (NamedMap& map : maps_of_all_kinds(30 + 13 * i, 2000 + i)) maps.push_back(std::move(map));
  maps.push_back({"large clutter", clutter(200, 200, 0.3, 2010)});
  for (const auto& [name, map] : maps) {
    const PlanningProblem problem = problem_on(map, 2020);
    const Grid<neural_reference::Wide> truth = neural_reference::equilibrium(problem, beta);
    for (const NeuralSolver solver : {NeuralSolver::tiles, NeuralSolver::active_list})
      EXPECT_EQ(wrong_directions(problem, truth, solved(problem, solver)), 0U) << name << ' ' << to_string(solver);
  }
}

/// Whoever solves it: what a path could not leave is counted from the landscape.
TEST(NeuralMap, DeadUnitsAreSeenInTheLandscape) {
  for (const Corners corners : {Corners::keep, Corners::cut})
    for (const Lattice lattice : {Lattice::rectangular, Lattice::wide, Lattice::hexagonal}) {
      PlanningProblem problem = problem_on(rooms(60, 50, 13, 2330), 2331);
      problem.corners = corners;
      problem.lattice = lattice;
      Grid<double> value = neural_map(problem).value;
      EXPECT_EQ(dead_units(problem, value), 0);
      const Cell lost = problem.targets[0] == Cell{5, 5} ? Cell{18, 18} : Cell{5, 5};
      const double before = std::exchange(value[lost], kNoValue);
      EXPECT_GE(dead_units(problem, value), 1) << "never woken";
      value[lost] = -1e-9;
      EXPECT_GE(dead_units(problem, value), 1) << "a local maximum";
      value[lost] = before;
      EXPECT_EQ(dead_units(problem, value), 0);
    }
}

/// What plain doubles would make of it: all below the least of them is 0.
TEST(NeuralMap, NeedsItsExponents) {
  constexpr double kLeast = -745.13;  // its logarithm
  const PlanningProblem open{.blocked = open_floor(1000, 500), .targets = {{0, 0}}};
  const Grid<double> value = neural_map(open).value;
  const auto lost = std::count_if(value.cells().begin(), value.cells().end(), [](double v) { return v < kLeast; });
  EXPECT_NEAR(static_cast<double>(lost) / 500000, 0.386, 0.001);
  EXPECT_GT(value[Cell(669, 0)], kLeast);
  EXPECT_LT(value[Cell(670, 0)], kLeast);
  const Grid<double> corridor = neural_map({.blocked = open_floor(700, 1), .targets = {{0, 0}}}).value;
  EXPECT_GT(corridor[Cell(324, 0)], kLeast);
  EXPECT_LT(corridor[Cell(325, 0)], kLeast);
}

}  // namespace
}  // namespace meander
