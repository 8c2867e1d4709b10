// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "planning/neural_map.hpp"
#include "planning/neural_tiles.hpp"
#include "planning_neural_maps.hpp"

namespace meander {
namespace {

using namespace neural_maps;

/// Maps whose sides are no multiples of a tile's.
std::vector<PlanningProblem> problems() {
  std::vector<PlanningProblem> all;
  for (int i = 0; i < 4; ++i)
    for (auto& [name, map] : maps_of_all_kinds(17 + 29 * i, 2100 + static_cast<std::uint64_t>(i))) {
      PlanningProblem problem = problem_on(map, 2200 + static_cast<std::uint64_t>(i));
      problem.corners = i % 2 == 0 ? Corners::keep : Corners::cut;
      all.push_back(std::move(problem));
    }
  return all;
}

void expect_same_bits(const PlanningResult& a, const PlanningResult& b) {
  EXPECT_EQ(a.statistics.relaxations, b.statistics.relaxations);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a.statistics.residual), std::bit_cast<std::uint64_t>(b.statistics.residual));
  EXPECT_TRUE(a.value == b.value);
}

TEST(NeuralTiles, EveryKernelGivesTheSameBits) {
  for (const PlanningProblem& problem : problems()) {
    const PlanningResult reference = solve_tiles(problem, {}, {}, tile_kernels().front());
    EXPECT_LT(reference.statistics.residual, 1e-6);
    for (const TileKernel* kernel : tile_kernels().subspan(1)) {
      SCOPED_TRACE(kernel->name);
      expect_same_bits(reference, solve_tiles(problem, {}, {}, kernel));
    }
  }
}

TEST(NeuralTiles, AnyNumberOfThreadsGivesTheSameBits) {
  std::vector<PlanningProblem> all = problems();
  all.push_back(problem_on(rooms(400, 300, 25, 2150), 2151));
  all.push_back(problem_on(open_floor(500, 300), 2152));
  for (const PlanningProblem& problem : all) {
    const TileKernel* kernel = tile_kernels().back();
    const PlanningResult alone = solve_tiles(problem, {.threads = 1}, {}, kernel);
    for (const int threads : {2, 3, 0}) expect_same_bits(alone, solve_tiles(problem, {.threads = threads}, {}, kernel));
  }
}

TEST(NeuralTiles, ProgressIsTold) {
  double last = 0;
  Work work;
  work.progress = [&](double fraction, std::string_view) {
    EXPECT_LE(fraction, 1);
    last = fraction;
  };
  solve_tiles(problem_on(open_floor(200, 200), 2153), {}, work);
  EXPECT_EQ(last, 1);
}

TEST(NeuralTiles, MazesAndSteepActivationAreRightWithTilesToo) {
  for (const double steepness : {0.35, 0.68, 0.9})
    for (const PlanningProblem& problem : problems()) {
      const NeuralMapOptions options{.steepness = steepness};
      const PlanningResult tiles = solve_tiles(problem, options, {}, tile_kernels().back());
      NeuralMapOptions other = options;
      other.solver = NeuralSolver::active_list;
      const PlanningResult list = neural_map(problem, other);
      ASSERT_EQ(tiles.statistics.cells, list.statistics.cells);
      double worst = 0;
      for (int y = 0; y < list.value.height(); ++y)
        for (int x = 0; x + 1 < list.value.width(); ++x) {
          const Cell a{x, y}, b{x + 1, y};
          ASSERT_EQ((tiles.value[a] == kNoValue), (list.value[a] == kNoValue)) << x << ' ' << y;
          if (list.value[a] != kNoValue && list.value[b] != kNoValue && problem.corners == Corners::keep)
            worst = std::max(worst, std::abs(tiles.value[b] - tiles.value[a] - (list.value[b] - list.value[a])));
        }
      EXPECT_LT(worst, steepness > 0.8 ? 4e-5 : 1e-5);
    }
}

TEST(NeuralTiles, TargetsAnywhereInATile) {
  for (int i = 0; i < 300; i += 7) {
    const PlanningProblem problem{.blocked = open_floor(19, 17), .targets = {{i % 19, i / 19}}};
    const PlanningResult result = solve_tiles(problem, {});
    EXPECT_LT(result.statistics.residual, 1e-6);
    EXPECT_EQ(result.value[problem.targets[0]], 0);
    EXPECT_EQ(result.statistics.cells, 19 * 17);
  }
}

/// Where tanh is taken for straight depends on the tolerance, however small it is.
TEST(NeuralTiles, HoldEveryTolerance) {
  const PlanningProblem problem{.blocked = open_floor(100, 100), .targets = {{54, 54}}};
  for (const double tolerance : {1e-12, 1e-10, 1e-8, 1e-4}) {
    const Grid<double> tiles = neural_map(problem, {.tolerance = tolerance}).value;
    const Grid<double> exact = neural_map(problem, {.solver = NeuralSolver::active_list, .tolerance = 1e-12}).value;
    double worst = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 99; ++x)
        worst = std::max(worst, std::abs(tiles[{x + 1, y}] - tiles[{x, y}] - exact[{x + 1, y}] + exact[{x, y}]));
    EXPECT_LT(worst, 4 * tolerance + 4e-12) << tolerance;
  }
}

}  // namespace
}  // namespace meander
