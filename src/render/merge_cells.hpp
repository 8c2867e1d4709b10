// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "render/draw_list.hpp"

namespace meander {

struct CellBlock {
  int x, y, width, height;
};
struct CellGroup {
  Color color;
  std::vector<CellBlock> blocks;
};

/// The visible cells as rectangles of equal colour, grouped by colour in the order of first appearance: a map of a few
/// colours becomes a few dozen rectangles.
std::vector<CellGroup> merged_cells(const DrawCells& cells);

}  // namespace meander
