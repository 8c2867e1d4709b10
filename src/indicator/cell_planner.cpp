// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/cell_planner.hpp"

#include <cmath>

namespace meander {
namespace {

/// Where a cell lies among cells and walls. The ring around is there because a robot does not know where its labyrinth
/// ends.
Cell among_walls(Cell cell) { return {2 * cell.x + 3, 2 * cell.y + 3}; }
int among_walls(int cells) { return 2 * (cells + 2) + 1; }

Cell wall_beside(Cell cell, int side) { return beside(among_walls(cell), side); }

}  // namespace

CellPlanner::CellPlanner(int columns, int rows, Cell goal)
    : goal_(goal), planner_(among_walls(columns), among_walls(rows), among_walls(goal), false) {
  if (goal.x < 0 || goal.y < 0 || goal.x >= columns || goal.y >= rows)
    fail("goal: a cell of the labyrinth expected, got ({}, {})", goal.x, goal.y);
  for (int y = 0; y < planner_.height(); y += 2)
    for (int x = 0; x < planner_.width(); x += 2) planner_.set_blocked({x, y}, true);  // corners of cells
}

void CellPlanner::look(const Labyrinth& labyrinth, Cell at) {
  for (int side = 0; side < kSides; ++side) {
    Cell cell = at;
    for (; labyrinth.open(cell, side); cell = beside(cell, side)) planner_.set_blocked(wall_beside(cell, side), false);
    planner_.set_blocked(wall_beside(cell, side), true);
  }
}

CellWalk CellPlanner::walk(const Labyrinth& labyrinth, Cell start, const Work& work) {
  if (among_walls(labyrinth.columns()) != planner_.width() || among_walls(labyrinth.rows()) != planner_.height())
    fail("labyrinth: one of {} x {} cells expected, got {} x {}", (planner_.width() - 5) / 2,
         (planner_.height() - 5) / 2, labyrinth.columns(), labyrinth.rows());
  if (!labyrinth.contains(start)) fail("start: a cell of the labyrinth expected, got ({}, {})", start.x, start.y);
  CellWalk walk;
  walk.visits = Grid<int>(labyrinth.columns(), labyrinth.rows());
  walk.last = start;
  proven_ = false;
  double expected = 0;
  for (;;) {
    work.poll();
    ++walk.visits[walk.last];
    look(labyrinth, walk.last);
    const std::vector<Cell>& way = planner_.plan(among_walls(walk.last), work);
    if (walk.decisions++ == 0) expected = planner_.length() / 2;
    if (way.empty()) {
      walk.ending = Ending::no_passable_direction;
      walk.reason = "no passable direction left: no way leads to the goal, with unknown taken as passable";
      return walk;
    }
    if (way.size() == 1) break;
    walk.last = {(way[2].x - 3) / 2, (way[2].y - 3) / 2};  // two steps: through what is between, to the next cell
    walk.walked += 1;
  }
  walk.ending = Ending::reached;
  walk.reason = "the goal is reached";
  proven_ = walk.walked <= expected;
  return walk;
}

}  // namespace meander
