// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/work.hpp"
#include "grid/labyrinth.hpp"
#include "indicator/explorer.hpp"

namespace meander {

/// The centre of a cell of side 1 m.
inline Vec2 cell_center(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

/// A run of an explorer over the cells of a labyrinth.
struct CellWalk {
  Ending ending = Ending::driving;
  std::string reason;
  double walked = 0;  ///< [m]
  int decisions = 0;
  Cell last;         ///< where it ended
  Grid<int> visits;  ///< how often it was on each cell
};

/// Lets an explorer decide on the cells of a labyrinth: a robot that recognises every crossing, dead end and indicator
/// without fail, follows corridors by itself and knows exactly where it is. It settles what the rules are worth, apart
/// from what sensors can see. Cells have a side of 1 m; cell (0, 0) has its centre at (0.5, 0.5).
CellWalk walk_cells(const Labyrinth& labyrinth, Cell start, Explorer& explorer, const Work& work = {});

/// Length of the shortest way between two cells [m]; negative: there is none.
double shortest_way(const Labyrinth& labyrinth, Cell from, Cell to);

/// Share of the cells that can be reached from `start` and were visited.
double coverage(const Labyrinth& labyrinth, Cell start, const CellWalk& walk);

}  // namespace meander
