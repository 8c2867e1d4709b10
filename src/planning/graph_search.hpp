// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/landscape.hpp"

namespace meander {

/// What A* and Theta* share: the cost so far, where a cell was reached from, and the open cells by estimated total
/// cost.
class GraphSearch {
 public:
  /// The start must be set, inside and free.
  explicit GraphSearch(const PlanningProblem& problem);

  /// The open cell of least estimate, closed now; none: everything was looked at.
  std::optional<Cell> next();
  bool is_target(Cell cell) const { return target_[cell] != 0; }
  bool closed(Cell cell) const { return closed_[cell] != 0; }
  double cost(Cell cell) const { return cost_[cell]; }
  Cell parent(Cell cell) const { return parent_[cell]; }
  /// Opens the cell, or takes the better of both ways to it.
  void offer(Cell cell, double cost, Cell parent);
  /// The cells' centres from the start to this cell.
  std::vector<Vec2> way_to(Cell cell) const;
  std::int64_t relaxations() const { return relaxations_; }

 private:
  struct Open {
    double estimate;
    double cost;
    Cell cell;
  };
  double remaining(Cell cell) const;

  const PlanningProblem& problem_;
  std::vector<Cell> targets_;
  double least_;  ///< cost of a cell of length, at least
  Grid<std::uint8_t> target_, closed_;
  Grid<double> cost_;
  Grid<Cell> parent_;
  std::vector<Open> open_;  ///< a heap
  std::int64_t relaxations_ = 0;
};

/// A result with the way, or why there is none.
PlanningResult search_result(const PlanningProblem& problem, const GraphSearch& search, std::optional<Cell> end);

/// Throws ArgumentError unless the start is set.
void need_start(const PlanningProblem& problem, const char* planner);

}  // namespace meander
