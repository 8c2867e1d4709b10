// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/harmonic.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <numbers>

#include "base/elementary.hpp"

namespace meander {
namespace {

/// The unknowns: cells from which a target can be reached, except the targets.
struct HarmonicSystem {
  explicit HarmonicSystem(const PlanningProblem& problem, const Work& work)
      : blocked(problem.blocked), number(blocked.width(), blocked.height(), kWall) {
    const Grid<std::uint8_t> reached = reachable_cells(problem, work);
    for (int y = 0; y < blocked.height(); ++y)
      for (int x = 0; x < blocked.width(); ++x)
        if (reached[{x, y}] != 0) number[{x, y}] = 0;
    for (const Cell target : free_targets(problem)) number[target] = kTarget;
    for (int y = 0; y < blocked.height(); ++y)
      for (int x = 0; x < blocked.width(); ++x)
        if (number[{x, y}] == 0) number[{x, y}] = static_cast<int>(cells.size()), cells.push_back({x, y});
  }
  template <class Visit>
  void neighbours(Cell cell, Visit visit) const {
    for (const LatticeStep& step : lattice_steps(Lattice::rectangular).first(4))
      visit(number.at({cell.x + step.dx, cell.y + step.dy}, kWall));
  }

  static constexpr int kWall = -1, kTarget = -2;
  const Grid<std::uint8_t>& blocked;
  Grid<int> number;
  std::vector<Cell> cells;
};

/// 4 p_i - sum of p_j = number of targets beside i.
Eigen::VectorXd exactly(const HarmonicSystem& system) {
  if (system.cells.size() > kMostExactCells)
    fail("harmonic: at most {} cells expected for solver = 'exact', got {}; solver = 'sor' takes any number",
         kMostExactCells, system.cells.size());
  const auto count = static_cast<Eigen::Index>(system.cells.size());
  Eigen::VectorXd beside = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    entries.emplace_back(i, i, 4);
    system.neighbours(system.cells[static_cast<std::size_t>(i)], [&](int j) {
      if (j == HarmonicSystem::kTarget) beside[i] += 1;
      if (j >= 0 && j < i) entries.emplace_back(i, j, -1);
    });
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(beside);
}

/// Gauss and Seidel's sweeps with over-relaxation, until no cell changes by more than the tolerance, relatively.
/// Over-relaxation carries the rounding of cells near 1 to all others: changes below kRounding never end and tell
/// nothing, so cells of a smaller chance may have no way up. That is the method, and counted as dead units.
Eigen::VectorXd by_sweeps(const HarmonicSystem& system, double tolerance, std::int64_t& relaxations, const Work& work) {
  constexpr double kRounding = 1e-15;
  const int side = std::max(system.blocked.width(), system.blocked.height());
  const double omega = 2 / (1 + sin_cos(std::numbers::pi / (side + 1)).sin);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(system.cells.size()));
  const auto value = [&](int j) { return j >= 0 ? p[j] : j == HarmonicSystem::kTarget ? 1.0 : 0.0; };
  for (double change = 1; change > tolerance;) {
    change = 0;
    for (std::size_t i = 0; i < system.cells.size(); ++i) {
      if (i % 4096 == 0) work.poll();
      double sum = 0;
      system.neighbours(system.cells[i], [&](int j) { sum += value(j); });
      double& here = p[static_cast<Eigen::Index>(i)];
      const double next = std::max(here + omega * (sum / 4 - here), 0.0);
      if (std::abs(next - here) > kRounding)
        change = std::max(change, std::abs(next - here) / std::max(next, kRounding));
      here = next;
    }
    relaxations += static_cast<std::int64_t>(system.cells.size());
  }
  return p;
}

/// The largest relative error of a cell's equation, and the cells that have no neighbour of a higher value.
void judge(const HarmonicSystem& system, const Eigen::VectorXd& p, PlanningStatistics& statistics) {
  for (std::size_t i = 0; i < system.cells.size(); ++i) {
    const double here = p[static_cast<Eigen::Index>(i)];
    double sum = 0, best = 0;
    system.neighbours(system.cells[i], [&](int j) {
      const double value = j >= 0 ? p[j] : j == HarmonicSystem::kTarget ? 1.0 : 0.0;
      sum += value;
      best = std::max(best, value);
    });
    if (!(here >= std::numeric_limits<double>::min()) || !(best > here))
      ++statistics.dead_units;
    else
      statistics.residual = std::max(statistics.residual, std::abs(sum / 4 / here - 1));
  }
}

}  // namespace

PlanningResult harmonic(const PlanningProblem& problem, const HarmonicOptions& options, const Work& work) {
  if (!problem.even() || problem.lattice != Lattice::rectangular || problem.corners != Corners::keep)
    fail("harmonic: a rectangular lattice, corners that are kept, no difficulty and no drag expected");
  const HarmonicSystem system(problem, work);
  PlanningResult result{
      .value = Grid<double>(problem.blocked.width(), problem.blocked.height(), kNoValue, problem.blocked.frame)};
  result.statistics.relaxations = static_cast<std::int64_t>(system.cells.size());
  const Eigen::VectorXd p = options.solver == HarmonicSolver::exact
                                ? exactly(system)
                                : by_sweeps(system, options.tolerance, result.statistics.relaxations, work);
  judge(system, p, result.statistics);
  result.statistics.solver = to_string(options.solver);
  for (std::size_t i = 0; i < system.cells.size(); ++i)
    if (const double chance = p[static_cast<Eigen::Index>(i)]; chance >= std::numeric_limits<double>::min())
      result.value[system.cells[i]] = logarithm(chance);
  for (const Cell target : free_targets(problem)) result.value[target] = 0;
  result.statistics.cells = static_cast<std::int64_t>(system.cells.size() + free_targets(problem).size());
  return result;
}

}  // namespace meander
