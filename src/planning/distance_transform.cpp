// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/distance_transform.hpp"

#include <algorithm>
#include <numbers>

#include "planning/bucket_queue.hpp"

namespace meander {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kBlocked = -1;  // no cost is less: a blocked cell never takes one
constexpr std::size_t kPoll = 8192;

/// Costs with a rim of blocked cells all round, so that no step needs to ask where the map ends.
struct PaddedCosts {
  explicit PaddedCosts(const Grid<std::uint8_t>& blocked)
      : width(blocked.width() + 2),
        cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(blocked.height() + 2), kBlocked) {
    for (int y = 0; y < blocked.height(); ++y)
      for (int x = 0; x < blocked.width(); ++x)
        if (blocked[{x, y}] == 0) cells[static_cast<std::size_t>(index({x, y}))] = kFar;
  }
  std::int32_t index(Cell cell) const { return (cell.y + 1) * width + cell.x + 1; }
  Cell cell(std::int32_t i) const { return {i % width - 1, i / width - 1}; }
  double& operator[](std::int32_t i) { return cells[static_cast<std::size_t>(i)]; }

  int width;
  std::vector<double> cells;
};

/// Cost is length on the 8-connected lattice: the benchmark's baseline. Returns the number of relaxations.
std::int64_t spread_even(PaddedCosts& cost, Corners corners, BucketQueue& queue, const Work& work) {
  const std::int32_t w = cost.width, right[4] = {1, -1, -1, 1}, up[4] = {w, -w, w, -w};
  const std::int32_t straight[4] = {1, -1, w, -w};
  const bool cut = corners == Corners::cut;
  std::int64_t relaxations = 0;
  std::vector<std::int32_t> items;
  for (std::size_t polled = kPoll; queue.pop(items); polled += items.size()) {
    if (polled >= kPoll) work.poll(), polled = 0;
    for (const std::int32_t i : items) {
      const double here = cost[i];
      if (!queue.in_turn(here)) continue;
      const auto offer = [&](std::int32_t to, double value) {
        if (!(value < cost[to])) return;
        cost[to] = value;
        queue.push(value, to);
        ++relaxations;
      };
      for (const std::int32_t step : straight) offer(i + step, here + 1);
      for (int k = 0; k < 4; ++k)
        if (cut || (cost[i + right[k]] >= 0 && cost[i + up[k]] >= 0))
          offer(i + right[k] + up[k], here + std::numbers::sqrt2);
    }
  }
  return relaxations;
}

/// Any lattice, any costs; the cost of a step is that of going it towards the target.
std::int64_t spread(const PlanningProblem& problem, PaddedCosts& cost, BucketQueue& queue, const Work& work) {
  std::int64_t relaxations = 0;
  std::vector<std::int32_t> items;
  for (std::size_t polled = kPoll; queue.pop(items); polled += items.size()) {
    if (polled >= kPoll) work.poll(), polled = 0;
    for (const std::int32_t i : items) {
      const double here = cost[i];
      if (!queue.in_turn(here)) continue;
      const Cell cell = cost.cell(i);
      const std::span<const LatticeStep> steps = lattice_steps(problem.lattice, cell.y);
      for (std::size_t k = 0; k < steps.size(); ++k) {
        if (!open_step(problem.blocked, problem.corners, cell, steps[k])) continue;
        const Cell from{cell.x + steps[k].dx, cell.y + steps[k].dy};
        const double value = here + step_cost(problem, from, lattice_steps(problem.lattice, from.y)[k ^ 1]);
        double& old = cost[cost.index(from)];
        if (!(value < old)) continue;
        old = value;
        queue.push(value, cost.index(from));
        ++relaxations;
      }
    }
  }
  return relaxations;
}

/// Upper limit of the cost of one step.
double most_step_cost(const PlanningProblem& problem) {
  double hardest = 1;
  for (std::size_t i = 0; i < problem.difficulty.cells().size(); ++i)
    hardest = std::max(hardest, static_cast<double>(problem.difficulty.cells()[i]));
  const double longest = lattice_steps(problem.lattice).back().length;
  return longest * hardest * (problem.drag.cells().empty() ? 1 : 2);
}

}  // namespace

PlanningResult distance_transform(const PlanningProblem& problem, const Work& work) {
  constexpr double kMostBuckets = 4096;
  PaddedCosts cost(problem.blocked);
  const double most = most_step_cost(problem);
  BucketQueue queue(std::max(std::min(least_difficulty(problem), most), most / kMostBuckets), most);
  for (const Cell target : free_targets(problem)) {
    cost[cost.index(target)] = 0;
    queue.push(0, cost.index(target));
  }
  const bool plain = problem.even() && problem.lattice == Lattice::rectangular;
  PlanningResult result{
      .value = Grid<double>(problem.blocked.width(), problem.blocked.height(), kNoValue, problem.blocked.frame),
      .logarithmic = false};
  result.statistics.relaxations =
      plain ? spread_even(cost, problem.corners, queue, work) : spread(problem, cost, queue, work);
  for (int y = 0; y < problem.blocked.height(); ++y)
    for (int x = 0; x < problem.blocked.width(); ++x) {
      const double value = cost[cost.index({x, y})];
      if (value < 0 || value == kFar) continue;
      result.value[{x, y}] = 0 - value;
      ++result.statistics.cells;
    }
  return result;
}

}  // namespace meander
