// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <vector>

#include "base/fields.hpp"
#include "base/work.hpp"
#include "geometry/shapes.hpp"
#include "grid/grid.hpp"

namespace meander {

struct TraceOptions {
  double epsilon = 0.49;  ///< [cells]
  double min_area = 0;    ///< [m^2]
};

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TraceOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"epsilon", "cells", "how far a straight outline may leave the edges of the cells that it replaces", 0,
              0.499},
        o.epsilon);
  visit(Field{"min_area", "m^2", "smaller solid patches are dropped as specks", 0, 1e6}, o.min_area);
}

struct Traced {
  std::vector<Polygon> solids;  ///< canonical and valid, in the order of their lowest, then leftmost cell
  int specks = 0;               ///< patches that were dropped
  std::size_t edges = 0;
  std::size_t holes = 0;
};

/// Outlines of the cells that are not 0, in metres (the grid's frame is honoured). Cells that touch at a corner belong
/// together, free cells do not: a diagonal wall does not leak. What holds for every raster, however ragged:
/// - the centre of each cell is on its side: solids contain exactly the centres of the solid cells (less the specks);
/// - no outline crosses or touches itself or another one; solids and free areas keep their number and their nesting;
/// - no outline is farther than one cell from the edges of the cells; right angles stay exact.
/// Beyond the grid all is free.
Traced trace(const Grid<std::uint8_t>& solid, const TraceOptions& options = {}, const Work& work = {});

}  // namespace meander
