// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/graph_search.hpp"

#include <algorithm>
#include <numbers>

namespace meander {
namespace {

/// Least length of a way over 8-connected free cells.
double octile(int dx, int dy) {
  const int less = std::min(std::abs(dx), std::abs(dy)), more = std::max(std::abs(dx), std::abs(dy));
  return less * std::numbers::sqrt2 + (more - less);
}

/// With more targets looking at each for every cell costs more than it saves: Dijkstra's algorithm then.
constexpr std::size_t kMostEstimated = 64;

/// Heaps put the least estimate first; of equal ones the one that has come farthest.
constexpr auto kLater = [](const auto& a, const auto& b) {
  return a.estimate != b.estimate ? a.estimate > b.estimate : a.cost < b.cost;
};

}  // namespace

GraphSearch::GraphSearch(const PlanningProblem& problem)
    : problem_(problem),
      targets_(free_targets(problem)),
      least_(least_difficulty(problem)),
      target_(problem.blocked.width(), problem.blocked.height()),
      closed_(problem.blocked.width(), problem.blocked.height()),
      cost_(problem.blocked.width(), problem.blocked.height(), std::numeric_limits<double>::infinity()),
      parent_(problem.blocked.width(), problem.blocked.height()) {
  for (const Cell target : targets_) target_[target] = 1;
  offer(*problem.start, 0, *problem.start);
}

double GraphSearch::remaining(Cell cell) const {
  if (targets_.size() > kMostEstimated) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Cell target : targets_)
    least = std::min(least, problem_.lattice == Lattice::rectangular
                                ? octile(target.x - cell.x, target.y - cell.y)
                                : (cell_center(problem_.lattice, target) - cell_center(problem_.lattice, cell)).norm());
  return least_ * least;
}

void GraphSearch::offer(Cell cell, double cost, Cell parent) {
  if (!(cost < cost_[cell])) return;
  cost_[cell] = cost;
  parent_[cell] = parent;
  ++relaxations_;
  open_.push_back({cost + remaining(cell), cost, cell});
  std::push_heap(open_.begin(), open_.end(), kLater);
}

std::optional<Cell> GraphSearch::next() {
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), kLater);
    const Open best = open_.back();
    open_.pop_back();
    if (closed_[best.cell] != 0 || best.cost > cost_[best.cell]) continue;
    closed_[best.cell] = 1;
    return best.cell;
  }
  return std::nullopt;
}

std::vector<Vec2> GraphSearch::way_to(Cell cell) const {
  std::vector<Vec2> way{cell_center(problem_.lattice, cell)};
  for (; !(parent_[cell] == cell); cell = parent_[cell]) way.push_back(cell_center(problem_.lattice, parent_[cell]));
  std::reverse(way.begin(), way.end());
  return way;
}

PlanningResult search_result(const PlanningProblem& problem, const GraphSearch& search, std::optional<Cell> end) {
  PlanningResult result{.value = {}};
  result.statistics.relaxations = search.relaxations();
  result.statistics.complete = false;
  if (end)
    result.way = search.way_to(*end);
  else
    result.reason = cut_off_reason(problem);
  return result;
}

void need_start(const PlanningProblem& problem, const char* planner) {
  if (!problem.start) fail("{}: a start expected, got none: it searches from there", planner);
}

}  // namespace meander
