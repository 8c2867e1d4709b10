// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/labyrinth.hpp"

#include <algorithm>

#include "base/random.hpp"

namespace meander {
namespace {

/// Which of the active cells grows next.
std::size_t grown(LabyrinthKind kind, std::size_t active, Stream& random) {
  const std::size_t any = static_cast<std::size_t>(random.below(static_cast<int>(active)));
  const bool newest = kind == LabyrinthKind::backtracker || (kind == LabyrinthKind::mixed && random.chance(0.5));
  return newest ? active - 1 : any;
}

/// Growing tree: from an active cell into a neighbour that is not part of the tree yet.
void grow_tree(Labyrinth& labyrinth, LabyrinthKind kind, Stream& random) {
  Grid<std::uint8_t> reached(labyrinth.columns(), labyrinth.rows());
  std::vector<Cell> active{{random.below(labyrinth.columns()), random.below(labyrinth.rows())}};
  reached[active[0]] = 1;
  while (!active.empty()) {
    const std::size_t i = grown(kind, active.size(), random);
    int sides[kSides], count = 0;
    for (int side = 0; side < kSides; ++side)
      if (reached.at(beside(active[i], side), 1) == 0) sides[count++] = side;
    if (count == 0) {
      active.erase(active.begin() + static_cast<std::ptrdiff_t>(i));
      continue;
    }
    const int side = sides[random.below(count)];
    labyrinth.set_open(active[i], side, true);
    active.push_back(beside(active[i], side));
    reached[active.back()] = 1;
  }
}

/// Calls visit(cell, side) once for every wall inside the cells from `low` to `high`.
template <class Visit>
void for_inner_walls(Cell low, Cell high, Visit visit) {
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) {
      if (x < high.x) visit(Cell{x, y}, 0);
      if (y < high.y) visit(Cell{x, y}, 1);
    }
}

}  // namespace

Labyrinth::Labyrinth(int columns, int rows) : open_(std::max(columns, 0), std::max(rows, 0)) {
  if (columns < 1 || rows < 1) fail("labyrinth: at least 1 x 1 cells expected, got {} x {}", columns, rows);
}

int Labyrinth::ways(Cell cell) const {
  int count = 0;
  for (int side = 0; side < kSides; ++side) count += open(cell, side);
  return count;
}

void Labyrinth::set_open(Cell cell, int side, bool open) {
  if (side < 0 || side >= kSides || !contains(cell) || !contains(beside(cell, side)))
    fail("labyrinth: a wall between two cells expected, got side {} of cell ({}, {})", side, cell.x, cell.y);
  const auto put = [&](Cell at, int bit) {
    const int mask = 1 << bit;
    open_[at] = static_cast<std::uint8_t>(open ? open_[at] | mask : open_[at] & ~mask);
  };
  put(cell, side);
  put(beside(cell, side), opposite(side));
}

Grid<int> Labyrinth::steps_from(Cell from) const {
  Grid<int> steps(columns(), rows(), -1);
  if (!contains(from)) fail("labyrinth: a cell of it expected, got ({}, {})", from.x, from.y);
  std::vector<Cell> queue{from};
  steps[from] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (int side = 0; side < kSides; ++side) {
      const Cell here = queue[i], next = beside(here, side);
      if (!open(here, side) || steps[next] >= 0) continue;
      steps[next] = steps[here] + 1;
      queue.push_back(next);
    }
  return steps;
}

Labyrinth make_labyrinth(const LabyrinthPlan& plan) {
  validate(plan);
  Labyrinth labyrinth(plan.columns, plan.rows);
  Stream tree(plan.seed, "labyrinth"), loops(plan.seed, "labyrinth loops"), rooms(plan.seed, "labyrinth rooms");
  grow_tree(labyrinth, plan.kind, tree);
  for_inner_walls({0, 0}, {plan.columns - 1, plan.rows - 1}, [&](Cell cell, int side) {
    if (!labyrinth.open(cell, side) && loops.chance(plan.loops)) labyrinth.set_open(cell, side, true);
  });
  for (int room = 0; room < plan.rooms; ++room) {
    const int width = std::min(2 + rooms.below(3), plan.columns), height = std::min(2 + rooms.below(3), plan.rows);
    const Cell low{rooms.below(plan.columns - width + 1), rooms.below(plan.rows - height + 1)};
    for_inner_walls(low, {low.x + width - 1, low.y + height - 1},
                    [&](Cell cell, int side) { labyrinth.set_open(cell, side, true); });
  }
  return labyrinth;
}

}  // namespace meander
