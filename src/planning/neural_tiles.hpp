// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/tile_solver.hpp"

namespace meander {

/// Is it for tiles: a rectangular lattice where cost is length?
bool fits_tiles(const PlanningProblem& problem, const NeuralMapOptions& options);
/// Do the tiles fall into units so small that the active list is faster?
bool is_maze(const TileMap& map);

/// [LM99+] The equilibrium on a rectangular lattice where cost is length: tiles of 16 x 16 cells whose rows fill whole
/// registers, taken up in the order of what they have to tell. The same bits with every kernel and number of threads.
/// Mazes, whose tiles fall into many small units, go to the active list, unless a kernel is asked for.
PlanningResult solve_tiles(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work = {},
                           const TileKernel* kernel = nullptr);

}  // namespace meander
