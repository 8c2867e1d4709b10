// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/cell_walk.hpp"

#include <cmath>

#include "geometry/angle.hpp"

namespace meander {
namespace {

double direction_of(int side) { return wrap_angle(side * (kPi / 2)); }
int side_of(double direction) { return (static_cast<int>(std::lround(direction / (kPi / 2))) + kSides) % kSides; }

class Walker {
 public:
  Walker(const Labyrinth& labyrinth, Cell start, const Explorer& explorer)
      : labyrinth_(labyrinth), explorer_(explorer), at_(start), visits_(labyrinth.columns(), labyrinth.rows()) {
    ++visits_[start];
  }

  Percept percept() const {
    Percept percept;
    percept.position = cell_center(at_);
    for (int side = 0; side < kSides; ++side)
      if (labyrinth_.open(at_, side)) percept.ports.push_back({direction_of(side), free(side)});
    if (back_ >= 0) percept.back = direction_of(back_);
    percept.walked = walked_;
    percept.blocked = blocked_;
    return percept;
  }

  /// Leaves by a side and follows the corridor to where there is something to decide.
  void leave(const Decision& decision) {
    int side = decision.back ? back_ : side_of(decision.direction);
    walked_ = 0;
    blocked_ = side < 0 || !labyrinth_.open(at_, side);
    while (!blocked_) {
      at_ = beside(at_, side);
      back_ = opposite(side);
      ++visits_[at_];
      walked_ += 1;
      if (explorer_.knows(cell_center(at_)) || labyrinth_.ways(at_) != 2 || at_goal()) return;
      for (int on = 0; on < kSides; ++on)
        if (on != back_ && labyrinth_.open(at_, on)) side = on;
    }
    if (decision.back) blocked_ = false;  // it never left
    back_ = -1;
  }

  Cell at() const { return at_; }
  Grid<int>& visits() { return visits_; }

 private:
  double free(int side) const {
    double length = 0.5;
    for (Cell cell = at_; labyrinth_.open(cell, side); cell = beside(cell, side)) length += 1;
    return length;
  }
  bool at_goal() const { return (cell_center(at_) - explorer_.goal()).norm() <= explorer_.options().tolerance; }

  const Labyrinth& labyrinth_;
  const Explorer& explorer_;
  Cell at_;
  int back_ = -1;
  double walked_ = 0;
  bool blocked_ = false;
  Grid<int> visits_;
};

}  // namespace

CellWalk walk_cells(const Labyrinth& labyrinth, Cell start, Explorer& explorer, const Work& work) {
  if (!labyrinth.contains(start)) fail("start: a cell of the labyrinth expected, got ({}, {})", start.x, start.y);
  explorer.begin();
  Walker walker(labyrinth, start, explorer);
  CellWalk walk;
  for (;;) {
    work.poll();
    const Decision& decision = explorer.step(walker.percept());
    if (decision.ending != Ending::driving) {
      walk.ending = decision.ending;
      walk.reason = decision.reason;
      break;
    }
    walker.leave(decision);
  }
  walk.walked = explorer.state().walked;
  walk.decisions = explorer.state().in_run;
  walk.last = walker.at();
  walk.visits = std::move(walker.visits());
  return walk;
}

double shortest_way(const Labyrinth& labyrinth, Cell from, Cell to) {
  if (!labyrinth.contains(to)) fail("a cell of the labyrinth expected, got ({}, {})", to.x, to.y);
  return labyrinth.steps_from(from)[to];
}

double coverage(const Labyrinth& labyrinth, Cell start, const CellWalk& walk) {
  const Grid<int> steps = labyrinth.steps_from(start);
  int reachable = 0, visited = 0;
  for (std::size_t i = 0; i < steps.cells().size(); ++i) {
    reachable += steps.cells()[i] >= 0;
    visited += steps.cells()[i] >= 0 && walk.visits.cells()[i] > 0;
  }
  return static_cast<double>(visited) / reachable;
}

}  // namespace meander
