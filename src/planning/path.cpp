// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/path.hpp"

#include "base/elementary.hpp"
#include "planning/gradient_path.hpp"

namespace meander {
namespace {

/// What the kind compares: by how much the neighbour is better, for the cost of the step.
double worth(PathKind kind, bool logarithmic, double rise, double cost) {
  // (v_j - v_i) / v_i = exp(ln v_j - ln v_i) - 1: the same order as v_j - v_i, and never an underflow.
  const double difference = logarithmic && kind == PathKind::slope ? exponential(std::min(rise, 700.0)) - 1 : rise;
  return kind == PathKind::steepest ? rise : difference / cost;
}

PlannedPath lattice_path(const PlanningProblem& problem, const PlanningResult& result, PathKind kind,
                         const Work& work) {
  PlannedPath path;
  Cell cell = *problem.start;
  path.points.push_back(cell_center(problem.lattice, cell));
  while (!is_target(problem, cell)) {
    if (path.points.size() % 4096 == 0) work.poll();
    const std::optional<Cell> next = best_neighbour(problem, result, kind, cell);
    if (!next)
      return {.points = {},
              .reason = fmt::format("no neighbour of cell ({}, {}) is nearer to a target", cell.x, cell.y)};
    cell = *next;
    path.points.push_back(cell_center(problem.lattice, cell));
  }
  return path;
}

}  // namespace

bool is_target(const PlanningProblem& problem, Cell cell) {
  for (const Cell target : problem.targets)
    if (target == cell) return true;
  return false;
}

std::optional<Cell> best_neighbour(const PlanningProblem& problem, const PlanningResult& result, PathKind kind,
                                   Cell cell) {
  std::optional<Cell> best;
  double most = 0;
  const double here = result.value[cell];
  for (const LatticeStep& step : lattice_steps(problem.lattice, cell.y)) {
    const Cell to{cell.x + step.dx, cell.y + step.dy};
    const double there = result.value.at(to, kNoValue);
    if (!(there > here) || !open_step(problem.blocked, problem.corners, cell, step)) continue;
    const double gain = worth(kind, result.logarithmic, there - here, step_cost(problem, cell, step));
    if (gain > most) most = gain, best = to;
  }
  return best;
}

PlannedPath extract_path(const PlanningProblem& problem, const PlanningResult& result, PathKind kind,
                         const Clearance& clearance, const Work& work) {
  if (!result.reason.empty()) return {.points = {}, .reason = result.reason};
  if (!problem.start) fail("path: a start expected, got none");
  if (!result.way.empty()) return {.points = result.way};
  if (result.value.at(*problem.start, kNoValue) == kNoValue)
    return {.points = {}, .reason = "the landscape has no value at the start"};
  return kind == PathKind::gradient ? gradient_path(problem, result, clearance, work)
                                    : lattice_path(problem, result, kind, work);
}

}  // namespace meander
