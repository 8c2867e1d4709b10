// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/landscape.hpp"
#include "planning/neural_map_options.hpp"
#include "planning/tile_kernel.hpp"

namespace meander {

/// [LM99+] The equilibrium on a rectangular lattice where cost is length: tiles of 16 x 16 cells whose rows fill whole
/// registers, taken up in the order of what they have to tell. The same bits with every kernel and number of threads.
/// Mazes, whose tiles fall into many small units, go to the active list, unless a kernel is asked for.
PlanningResult solve_tiles(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work = {},
                           const TileKernel* kernel = nullptr);

}  // namespace meander
