// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/harmonic.hpp"

#include <gtest/gtest.h>

#include "planning_maps.hpp"

namespace meander {
namespace {

TEST(PlanningHarmonic, SweepsComeToTheExactSolution) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const PlanningProblem problem = random_problem(seed, 24, 20, 0.15);
    const PlanningResult exact = harmonic(problem), sweeps = harmonic(problem, {HarmonicSolver::sor, 1e-11});
    for (std::size_t i = 0; i < exact.value.cells().size(); ++i) {
      const double a = exact.value.cells()[i], b = sweeps.value.cells()[i];
      // Over-relaxation carries rounding errors from cells of chance 1 to those of chance e^-30.
      if (a > -14) {
        EXPECT_NEAR(a, b, 1e-6) << seed;
      }
      EXPECT_EQ(a == kNoValue, b == kNoValue);
    }
    EXPECT_LT(exact.statistics.residual, 1e-9);
    EXPECT_EQ(exact.statistics.dead_units, 0);
    EXPECT_GT(sweeps.statistics.relaxations, exact.statistics.relaxations);
  }
}

TEST(PlanningHarmonic, IsTheChanceOfARandomWalk) {
  // From a cell beside the target of a row of three, whose rows above and below are walls: 4 p = 1 + 0.
  const PlanningResult result = harmonic(drawn_problem({"#####", "#T..#", "#####"}));
  // 4 a = 1 + b, 4 b = a: a = 4/15, b = 1/15.
  EXPECT_NEAR(result.value[Cell(2, 1)], std::log(4.0 / 15), 1e-14);
  EXPECT_NEAR(result.value[Cell(3, 1)], std::log(1.0 / 15), 1e-14);
}

TEST(PlanningHarmonic, SaysWhereItDies) {
  // ln p falls by ln(2 + sqrt 3) = 1.317 a cell in a corridor: below the smallest double after 538.
  PlanningProblem problem{.blocked = Grid<std::uint8_t>(700, 1), .targets = {{0, 0}}};
  const PlanningResult result = harmonic(problem);
  EXPECT_GT(result.statistics.dead_units, 100);
  EXPECT_NE(result.value[Cell(537, 0)], kNoValue);
  EXPECT_EQ(result.value[Cell(538, 0)], kNoValue);
  EXPECT_EQ(result.value[Cell(699, 0)], kNoValue);
}

TEST(PlanningHarmonic, StopsWhenAsked) {
  StopToken stop;
  stop.request();
  EXPECT_THROW(harmonic(random_problem(1, 200, 200, 0.1), {HarmonicSolver::sor, 1e-9}, {.stop = &stop, .progress = {}}),
               Cancelled);
}

}  // namespace
}  // namespace meander
