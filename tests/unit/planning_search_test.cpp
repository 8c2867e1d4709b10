// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <filesystem>

#include "grid/movingai.hpp"
#include "planning/clearance.hpp"
#include "planning/planners.hpp"
#include "planning/theta_star.hpp"
#include "planning_maps.hpp"

namespace meander {
namespace {

double length_of(const std::vector<Vec2>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

TEST(PlanningSearch, AstarAgreesWithTheDistanceTransformEverywhere) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    for (const Corners corners : {Corners::keep, Corners::cut})
      for (const Lattice lattice : {Lattice::rectangular, Lattice::wide, Lattice::hexagonal}) {
        PlanningProblem problem = random_problem(seed, 23, 17, 0.3);
        problem.corners = corners;
        problem.lattice = lattice;
        const PlanningResult landscape = solve(problem, "distance_transform");
        ASSERT_EQ(landscape.reason, "");
        const Grid<std::uint8_t> reached = reachable_cells(problem);
        for (int i = 0; i < 10; ++i) {
          problem.start = Cell{(7 * i) % 23, (5 * i) % 17};
          const PlanningResult found = solve(problem, "astar");
          const double value = landscape.value[*problem.start];
          ASSERT_EQ(found.way.empty(), value == kNoValue) << seed << found.reason;
          ASSERT_EQ(reached[*problem.start] != 0, value != kNoValue);
          if (found.way.empty()) continue;
          ASSERT_NEAR(length_of(found.way), -value, 1e-9) << seed;
        }
      }
  }
}

TEST(PlanningSearch, CostsOfDifficultyAndDragAreTheSameForBoth) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    PlanningProblem problem = random_problem(seed, 19, 21, 0.2);
    add_terrain(problem, seed);
    const PlanningResult landscape = solve(problem, "distance_transform");
    for (int i = 0; i < 10; ++i) {
      problem.start = Cell{(5 * i) % 19, (8 * i) % 21};
      const PlanningResult found = solve(problem, "astar");
      const double value = landscape.value[*problem.start];
      ASSERT_EQ(found.way.empty(), value == kNoValue);
      double cost = 0;
      for (std::size_t k = 1; k < found.way.size(); ++k) {
        const Cell from = cell_at(problem.lattice, found.way[k - 1]), to = cell_at(problem.lattice, found.way[k]);
        for (const LatticeStep& step : lattice_steps(problem.lattice))
          if (step.dx == to.x - from.x && step.dy == to.y - from.y) cost += step_cost(problem, from, step);
      }
      if (found.way.empty()) continue;
      ASSERT_NEAR(cost, -value, 1e-9 * (1 - value)) << seed;
    }
  }
}

TEST(PlanningSearch, ThetaStarIsNeverLongerThanTheLatticeAndKeepsClear) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    PlanningProblem problem = random_problem(seed, 31, 24, 0.15);
    const Clearance clearance(problem.blocked);
    for (int i = 0; i < 5; ++i) {
      problem.start = Cell{(11 * i) % 31, (7 * i) % 24};
      const PlanningResult lattice = solve(problem, "astar"), any = solve(problem, "theta_star");
      ASSERT_EQ(lattice.way.empty(), any.way.empty());
      if (any.way.empty()) continue;
      EXPECT_LE(length_of(any.way), length_of(lattice.way) + 1e-9);
      for (std::size_t k = 1; k < any.way.size(); ++k) EXPECT_GT(clearance.of(any.way[k - 1], any.way[k]), 0);
    }
  }
}

TEST(PlanningSearch, LineOfSightIsThatOfTheClearance) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const PlanningProblem problem = random_problem(seed, 13, 13, 0.12);
    const Clearance clearance(problem.blocked);
    Stream stream(seed, "sight");
    for (int i = 0; i < 200; ++i) {
      const Cell a{stream.below(13), stream.below(13)}, b{stream.below(13), stream.below(13)};
      if (problem.blocked[a] != 0) continue;
      const double free = clearance.of(cell_center(Lattice::rectangular, a), cell_center(Lattice::rectangular, b));
      EXPECT_EQ(line_of_sight(problem.blocked, Corners::keep, a, b), free > 1e-9) << seed << " " << free;
      EXPECT_EQ(line_of_sight(problem.blocked, Corners::cut, a, b), free >= 0) << seed << " " << free;
    }
  }
}

// The lengths of movingai.com, which nobody here wrote.
TEST(PlanningSearch, LengthsAreThePublishedOnes) {
  const std::filesystem::path folder = std::filesystem::path(MEANDER_SOURCE_DIR) / "../shared/data/movingai";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there: nothing was compared";
  int compared = 0;
  for (const char* name : {"arena", "den312d", "Berlin_0_256"}) {
    const std::string path = (folder / (std::string(name) + ".map")).string();
    PlanningProblem problem{.blocked = read_movingai_map(path).blocked, .targets = {}};
    const auto tasks = read_movingai_scenarios(path + ".scen", problem.blocked.width(), problem.blocked.height());
    for (std::size_t i = 0; i < tasks.size(); i += 10, ++compared) {
      problem.start = tasks[i].start;
      problem.targets = {tasks[i].goal};
      ASSERT_NEAR(length_of(solve(problem, "astar").way), tasks[i].length, 1e-3) << name << " " << i;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(PlanningSearch, ManyTargetsCostNoMoreThanFew) {
  PlanningProblem problem = random_problem(7, 400, 400, 0.2);
  problem.targets.clear();
  for (int i = 0; i < 20000; ++i) problem.targets.push_back({200 + i % 200, 300 + i / 200});
  problem.start = Cell{3, 3};
  problem.blocked[*problem.start] = 0;
  const PlanningResult landscape = solve(problem, "distance_transform");
  const PlanningResult search = solve(problem, "astar");
  ASSERT_EQ(search.reason, landscape.reason);
  EXPECT_NEAR(length_of(search.way), -landscape.value[*problem.start], 1e-9);
  EXPECT_EQ(solve(problem, "theta_star").reason, "");
}

}  // namespace
}  // namespace meander
