// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/path.hpp"

#include <gtest/gtest.h>

#include "planning/path_measures.hpp"
#include "planning/planners.hpp"
#include "planning_maps.hpp"

namespace meander {
namespace {

constexpr PathKind kKinds[] = {PathKind::gradient, PathKind::steepest, PathKind::slope, PathKind::log_slope};

/// Every path of every planner and kind, from a free start that has one.
void each_path(PlanningProblem problem, const std::function<void(const std::string&, const PlannedPath&)>& visit) {
  const Clearance clearance(problem.solid());
  for (const std::string planner : {"neural_map", "distance_transform", "harmonic", "theta_star"}) {
    if (planner == "harmonic" && !problem.even()) continue;
    if (planner == "theta_star" && !problem.even()) continue;
    const PlanningResult result = solve(problem, planner);
    if (!result.reason.empty()) return;
    for (const PathKind kind : kKinds)
      visit(planner + " " + to_string(kind), extract_path(problem, result, kind, clearance));
  }
}

TEST(PlanningPath, LeadsFromTheStartToATargetAndKeepsClear) {
  int paths = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    PlanningProblem problem = random_problem(seed, 40, 33, 0.05 + 0.004 * static_cast<double>(seed));
    problem.start = Cell{static_cast<int>(seed % 40), static_cast<int>(7 * seed % 33)};
    const Clearance clearance(problem.blocked);
    each_path(problem, [&](const std::string& name, const PlannedPath& path) {
      // A harmonic function may have no way up where it underflows or is flat to the last digit.
      if (name.find("harmonic") == 0 && !path.reason.empty()) return;
      ASSERT_EQ(path.reason, "") << name << " " << seed;
      ++paths;
      EXPECT_EQ(path.points.front(), cell_center(problem.lattice, *problem.start));
      EXPECT_TRUE(is_target(problem, cell_at(problem.lattice, path.points.back())));
      const PathMeasures measures = measure_path(path.points, clearance);
      EXPECT_GT(measures.clearance_min, 0) << name << " " << seed;
      EXPECT_TRUE(certified(measures, 0));
    });
  }
  EXPECT_GT(paths, 400);
}

TEST(PlanningPath, OfARobotIsCertifiedForItsRadius) {
  int paths = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    PlanningProblem problem = random_problem(seed, 60, 50, 0.008);
    problem.obstacles = problem.blocked;
    problem.robot_radius = 0.6 + 0.07 * static_cast<double>(seed % 40);
    problem.blocked = blocked_for(problem.obstacles, problem.robot_radius);
    problem.start = Cell{static_cast<int>(11 * seed % 60), static_cast<int>(7 * seed % 50)};
    const Clearance clearance(problem.obstacles);
    each_path(problem, [&](const std::string& name, const PlannedPath& path) {
      ASSERT_EQ(path.reason, "") << name << " " << seed;
      const PathMeasures measures = measure_path(path.points, clearance);
      EXPECT_TRUE(certified(measures, problem.robot_radius))
          << name << " " << seed << " " << measures.clearance_min << " " << problem.robot_radius;
      ++paths;
    });
  }
  EXPECT_GT(paths, 200);
}

TEST(PlanningPath, LatticePathsClimb) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    PlanningProblem problem = random_problem(seed, 30, 30, 0.2);
    if (seed % 2 == 0) add_terrain(problem, seed);
    problem.start = Cell{3, 4};
    for (const std::string planner : {"neural_map", "distance_transform"}) {
      const PlanningResult result = solve(problem, planner);
      if (!result.reason.empty()) continue;
      for (const PathKind kind : {PathKind::steepest, PathKind::slope, PathKind::log_slope}) {
        const PlannedPath path = extract_path(problem, result, kind, Clearance(problem.blocked));
        ASSERT_EQ(path.reason, "") << planner << " " << seed;
        for (std::size_t i = 1; i < path.points.size(); ++i)
          EXPECT_GT(result.value[cell_at(problem.lattice, path.points[i])],
                    result.value[cell_at(problem.lattice, path.points[i - 1])]);
      }
    }
  }
}

TEST(PlanningPath, FollowsTheStraightLineInTheOpen) {
  PlanningProblem problem{.blocked = Grid<std::uint8_t>(80, 60), .targets = {{60, 42}}};
  problem.start = Cell{20, 17};
  const Clearance clearance(problem.blocked);
  const PlanningResult result = solve(problem, "neural_map");
  const PathMeasures smooth =
      measure_path(extract_path(problem, result, PathKind::gradient, clearance).points, clearance);
  const PathMeasures lattice =
      measure_path(extract_path(problem, result, PathKind::steepest, clearance).points, clearance);
  const double straight = Vec2(40, 25).norm();
  EXPECT_LT(smooth.length, 1.005 * straight);
  EXPECT_GT(lattice.length, 1.04 * straight);
  EXPECT_LT(smooth.turning, 0.8);
}

TEST(PlanningPath, MeasuresAreWhatTheySay) {
  PlanningProblem problem = drawn_problem({"..........", "..........", "....#.....", "..........", ".........."});
  const Clearance clearance(problem.blocked);
  const PathMeasures straight = measure_path({{1, 3.5}, {9, 3.5}}, clearance);
  EXPECT_DOUBLE_EQ(straight.length, 8);
  EXPECT_DOUBLE_EQ(straight.turning, 0);
  EXPECT_DOUBLE_EQ(straight.clearance_min, 0.5);
  EXPECT_EQ(measure_path({{1, 2.5}, {9, 2.5}}, clearance).clearance_min, -1);
  EXPECT_EQ(measure_path({{1, 2.5}, {11, 2.5}}, clearance).clearance_min, -1);
  EXPECT_NEAR(measure_path({{1, 1}, {9, 1}, {9, 4}}, clearance).turning, kPi / 2, 1e-12);
  EXPECT_EQ(resampled({{0, 0}, {2.5, 0}}, 1).size(), 4u);
}

TEST(PlanningClearance, IsThatOfTheNearestSquare) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const PlanningProblem problem = random_problem(seed, 17, 15, 0.06);
    const Clearance clearance(problem.blocked);
    Stream stream(seed, "pieces");
    for (int i = 0; i < 100; ++i) {
      const Vec2 a(stream.uniform(0, 17), stream.uniform(0, 15)), b(stream.uniform(0, 17), stream.uniform(0, 15));
      double least = std::min({a.x(), a.y(), b.x(), b.y(), 17 - a.x(), 17 - b.x(), 15 - a.y(), 15 - b.y()});
      for (int y = 0; y < 15; ++y)
        for (int x = 0; x < 17; ++x)
          if (problem.blocked[{x, y}] != 0) least = std::min(least, distance_to_square(a, b, x, y));
      ASSERT_NEAR(clearance.of(a, b), least, 1e-9) << seed;
      const double enough = stream.uniform(0, 3);
      ASSERT_EQ(clearance.of(a, b, enough) >= enough, least >= enough) << seed;
    }
  }
}

}  // namespace
}  // namespace meander
