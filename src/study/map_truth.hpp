// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "grid/grid.hpp"
#include "robot/cell_truth.hpp"
#include "sim/sim.hpp"

namespace meander {

struct MapTruthOptions {
  double slack = 0.07;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapTruthOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"slack", "m", "cells so far behind the first surface on the line of sight still count as seen", 0, 10},
        o.slack);
}

/// The truth about the cells of a grid of this shape and place, in the frame of the world. Hidden are those out of the
/// robot's line of sight, under its body, and outside the bounds of the world. Occupied are all that an obstacle or a
/// closed door reaches into. Throws ArgumentError when the grid is turned or has too many cells.
Grid<CellTruth> map_truth(const Sim& sim, std::size_t robot, int width, int height, const GridFrame& frame,
                          const MapTruthOptions& options = {});

}  // namespace meander
