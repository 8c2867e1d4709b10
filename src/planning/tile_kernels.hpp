// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/tile_kernel.hpp"

namespace meander {

// Each in a file of its own that is compiled for its processors; null where the compiler has none of them.
extern const TileKernel kPortableTileKernel;
extern const TileKernel kSse2TileKernel;
extern const TileKernel kAvx2TileKernel;
extern const TileKernel kAvx512TileKernel;

}  // namespace meander
