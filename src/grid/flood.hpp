// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <vector>

#include "grid/grid.hpp"

namespace meander {

enum class Neighbours { four, eight };

/// The connected areas of the cells that are not 0.
struct Components {
  Grid<std::int32_t> label;  ///< -1 for cells that are 0; areas are numbered from 0 by their first cell, row by row
  std::vector<std::size_t> cells;  ///< number of cells of each area
};
Components components(const Grid<std::uint8_t>& open, Neighbours neighbours);

}  // namespace meander
