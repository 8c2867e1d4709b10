// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>

#include "planning/clearance.hpp"
#include "planning/planners.hpp"
#include "planning_maps.hpp"

namespace meander {
namespace {

std::string complaint(const PlanningProblem& problem, const std::string& planner = "distance_transform",
                      const PlannerOptions& options = {}) {
  try {
    solve(problem, planner, options);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "none";
}
std::string reason(const PlanningProblem& problem) {
  std::string all;
  for (const std::string& planner : planner_names()) {
    const PlanningResult result = solve(problem, planner);
    EXPECT_TRUE(result.way.empty() && result.value.cells().empty()) << planner;
    if (all.empty()) all = result.reason;
    EXPECT_EQ(all, result.reason) << planner;
  }
  return all;
}

TEST(PlanningProblem, MisuseIsAnError) {
  EXPECT_EQ(complaint({.blocked = {}, .targets = {{0, 0}}}), "map: at least one cell expected, got 0 x 0");
  PlanningProblem problem = drawn_problem({"S..", "...", "..."});
  EXPECT_EQ(complaint(problem), "targets: at least one expected, got none");
  problem.targets = {{1, 1}};
  problem.robot_radius = -1;
  EXPECT_EQ(complaint(problem), "robot_radius: a number >= 0 expected, got -1");
  problem.robot_radius = 0;
  problem.difficulty = Grid<float>(2, 3, 1);
  EXPECT_EQ(complaint(problem), "difficulty: a grid of 3 x 3 cells expected, like the map, got 2 x 3");
  for (const float bad : {0.0F, -1.0F, 1e-40F, 1e5F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    problem.difficulty = Grid<float>(3, 3, 1);
    problem.difficulty[{2, 2}] = bad;
    EXPECT_NE(complaint(problem).find("difficulty: numbers from 0.001 to 1000 expected, got"), std::string::npos)
        << bad;
  }
  problem.difficulty = {};
  problem.drag = Grid<Eigen::Vector2f>(3, 3, Eigen::Vector2f(0, 1));
  EXPECT_EQ(complaint(problem), "drag: vectors of length up to 0.999 expected, got (0, 1)");
  problem.drag = Grid<Eigen::Vector2f>(3, 3, Eigen::Vector2f(0, std::nanf("")));
  EXPECT_NE(complaint(problem), "none");
  problem.drag = {};
  EXPECT_EQ(complaint(problem, "astra"),
            "unknown planner 'astra'; did you mean 'astar'? (known: neural_map, distance_transform, harmonic, astar, "
            "theta_star)");
  PlannerOptions options;
  options.neural_map.steepness = 1.5;
  EXPECT_EQ(complaint(problem, "neural_map", options),
            "option 'steepness': a number from 0.35 to 0.9 expected, got 1.5");
  problem.start.reset();
  EXPECT_EQ(complaint(problem, "astar"), "astar: a start expected, got none: it searches from there");
  problem.difficulty = Grid<float>(3, 3, 2);
  problem.start = Cell{0, 0};
  EXPECT_NE(complaint(problem, "theta_star").find("no difficulty and no drag expected"), std::string::npos);
  EXPECT_NE(complaint(problem, "harmonic").find("no difficulty and no drag expected"), std::string::npos);
  problem.difficulty = {};
  problem.lattice = Lattice::wide;
  for (const char* planner : {"harmonic", "theta_star"})
    EXPECT_EQ(complaint(problem, planner),
              fmt::format("planner '{}': lattice 'rectangular' expected, got 'wide'", planner));
}

TEST(PlanningProblem, NoPathIsAReason) {
  EXPECT_EQ(reason(drawn_problem({"S#T"})),
            "the start in cell (0, 0) at (0.50, 0.50) m is cut off from the target in cell (2, 0) at (2.50, 0.50) m");
  EXPECT_EQ(reason(drawn_problem({"S#T", "#TT"})),
            "the start in cell (0, 1) at (0.50, 1.50) m is cut off from all 3 targets");
  PlanningProblem problem = drawn_problem({"S#.", "..."});
  problem.targets = {{1, 1}};
  EXPECT_EQ(reason(problem), "the target in cell (1, 1) at (1.50, 1.50) m lies in a wall");
  problem.targets = {{1, 1}, {7, -1}};
  EXPECT_EQ(reason(problem), "no target can be stood on: the target in cell (1, 1) at (1.50, 1.50) m lies in a wall");
  problem.targets = {{3, 1}};
  EXPECT_EQ(reason(problem), "the target in cell (3, 1) at (3.50, 1.50) m lies outside of the map of 3 x 2 cells");
  problem.targets = {{2, 1}};
  problem.start = Cell{1, 1};
  EXPECT_EQ(reason(problem), "the start in cell (1, 1) at (1.50, 1.50) m lies in a wall");
  problem.start = Cell{-1, 1};
  EXPECT_EQ(reason(problem), "the start in cell (-1, 1) at (-0.50, 1.50) m lies outside of the map of 3 x 2 cells");
  problem = drawn_problem({"S......", ".......", "......T"});
  problem.obstacles = problem.blocked;
  problem.robot_radius = 1;
  problem.blocked = blocked_for(problem.obstacles, problem.robot_radius);
  EXPECT_EQ(reason(problem), "the target in cell (6, 0) at (6.50, 0.50) m is nearer to a wall than the robot's radius");
}

TEST(PlanningProblem, TheSmallestMapsHaveTheirWays) {
  for (const auto& rows : std::vector<std::vector<std::string>>{{"T"}, {"S..T"}, {"S", ".", "T"}, {"ST"}}) {
    PlanningProblem problem = drawn_problem(rows);
    if (!problem.start) problem.start = problem.targets.front();
    for (const std::string& planner : planner_names()) {
      const PlanningResult result = solve(problem, planner);
      EXPECT_EQ(result.reason, "") << planner;
      EXPECT_FALSE(result.way.empty() && result.value.cells().empty()) << planner;
    }
  }
}

TEST(PlanningProblem, AWallBetweenDiagonalsIsPassedOnlyWhenCornersAreCut) {
  PlanningProblem problem = drawn_problem({"S#", "#T"});
  EXPECT_NE(reason(problem), "");
  problem.corners = Corners::cut;
  for (const std::string planner : {"neural_map", "distance_transform", "astar", "theta_star"})
    EXPECT_EQ(solve(problem, planner).reason, "") << planner;
}

// The promise of blocked_for(): no step between cells that are left brings the robot's body to anything solid.
TEST(PlanningProblem, StepsBetweenCellsThatAreLeftKeepTheWholeRobotClear) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Grid<std::uint8_t> solid = random_problem(seed, 30, 26, 0.02).blocked;
    const double radius = 0.3 * static_cast<double>(seed % 9);
    const Grid<std::uint8_t> blocked = blocked_for(solid, radius);
    const Clearance clearance(solid);
    for (int y = 0; y < 26; ++y)
      for (int x = 0; x < 30; ++x) {
        const Cell cell{x, y};
        const Vec2 center = cell_center(Lattice::rectangular, cell);
        if (blocked[cell] != 0) {
          EXPECT_LT(clearance.of(center), std::sqrt(radius * radius + 0.5) + 1e-9);
          continue;
        }
        for (const LatticeStep& step : lattice_steps(Lattice::rectangular)) {
          if (!open_step(blocked, Corners::keep, cell, step)) continue;
          ASSERT_GE(clearance.of(center, center + Vec2(step.dx, step.dy)), radius - 1e-9) << seed << " " << radius;
        }
      }
  }
}

TEST(PlanningProblem, NobodyStandsAnywhereInAMapThatIsNarrowerThanTheRobot) {
  for (int width = 1; width < 9; ++width)
    for (const double radius : {0.51, 0.9, 1.4, 1.5, 1.6, 2.4, 2.5, 3.4, 3.5, 7.0}) {
      const Grid<std::uint8_t> solid(width, 7);
      const Grid<std::uint8_t> blocked = blocked_for(solid, radius);
      const double reach = std::sqrt(radius * radius + 0.5);
      for (int y = 0; y < 7; ++y)
        for (int x = 0; x < width; ++x) {
          const double rim = std::min({x, width - 1 - x, y, 6 - y}) + 0.5;
          EXPECT_EQ(blocked[Cell(x, y)] != 0, rim < reach) << width << " " << radius << " " << x << " " << y;
        }
    }
  const Grid<std::uint8_t> large = blocked_for(Grid<std::uint8_t>(3000, 3000), 1e6);  // at once, not in minutes
  EXPECT_EQ(std::count(large.cells().begin(), large.cells().end(), 1), 3000 * 3000);
}

TEST(PlanningProblem, OppositeStepsStandSideBySide) {
  for (const Lattice lattice : {Lattice::rectangular, Lattice::wide, Lattice::hexagonal})
    for (const int row : {0, 1}) {
      const auto steps = lattice_steps(lattice, row);
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const Cell from{5, row}, to{5 + steps[k].dx, row + steps[k].dy};
        const LatticeStep& back = lattice_steps(lattice, to.y)[k ^ 1];
        EXPECT_EQ((Cell{to.x + back.dx, to.y + back.dy}), from);
        EXPECT_NEAR((cell_center(lattice, to) - cell_center(lattice, from)).norm(), steps[k].length, 1e-12);
        EXPECT_EQ(cell_at(lattice, cell_center(lattice, to) + Vec2(0.1, -0.2)), to);
      }
    }
}

}  // namespace
}  // namespace meander
