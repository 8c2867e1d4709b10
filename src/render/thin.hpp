// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <vector>

namespace meander {

/// Which blocks of a coarse picture are wall, given how much of each block (0 .. full) walls cover; row-major. Blocks
/// that are at least half covered are. Of the others only those are without which a wall would tear or lose its end,
/// corners included: walls of any thinness stay visible, unbroken and one block wide, and no room springs a leak.
/// (Homotopic thinning, weakest blocks first, with walls joined along rows and columns.)
std::vector<std::uint8_t> thinned_walls(const std::vector<int>& cover, int columns, int rows, int full);

}  // namespace meander
