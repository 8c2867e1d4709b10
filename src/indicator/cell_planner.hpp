// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "indicator/cell_walk.hpp"
#include "indicator/dstar_lite.hpp"

namespace meander {

/// What explorers on cells are compared with that keeps a map in the place of a graph: always the shortest way to the
/// goal as if all passages were open that were not seen closed, [KL02]. It sees what walk_cells() tells: which sides of
/// its cell are open, and how far. What is known stays known from run to run.
class CellPlanner {
 public:
  /// For labyrinths of this size. Throws ArgumentError when the goal is not in it.
  CellPlanner(int columns, int rows, Cell goal);

  /// A run. Throws ArgumentError when the labyrinth is of another size, or the start is not in it.
  CellWalk walk(const Labyrinth& labyrinth, Cell start, const Work& work = {});

  /// The last run was as long as the way that was expected at its start, through cells that might all have been open:
  /// there is no shorter one.
  bool proven() const { return proven_; }
  std::size_t bytes() const { return planner_.bytes(); }

 private:
  void look(const Labyrinth& labyrinth, Cell at);

  Cell goal_;
  DStarLite planner_;  ///< cells and what is between them: a wall is a cell; a ring of them lies around the labyrinth
  bool proven_ = false;
};

}  // namespace meander
