// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "render/canvas.hpp"

namespace meander {

/// What a block of canvas pixels shows as a whole.
struct Pool {
  Color color;
  Mark mark = Mark::ground;
};

/// Blocks of width x height pixels, row-major. Averages would wash thin walls out, so it is decided first which blocks
/// are wall or closed door (see thinned_walls): those show only the wall's colour, the others only the rest.
std::vector<Pool> pooled(const Canvas& canvas, int block_width, int block_height);

}  // namespace meander
