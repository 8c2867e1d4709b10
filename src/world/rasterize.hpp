// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>

#include "base/work.hpp"
#include "grid/grid.hpp"
#include "world/world.hpp"

namespace meander {

/// Largest raster that is made: width x height.
inline constexpr double kMaxCells = 1e8;

/// What blocks the way now (obstacles and closed doors) as cells: 1 for every cell that a wall or a solid reaches into,
/// 0 else. A solid that ends exactly at the side of a cell does not reach into it, so what was traced from cells comes
/// back as the same cells; a thin wall along a side takes the cells on both sides. Discs are exact. The grid begins at
/// `box.low` and covers the box. Throws ArgumentError.
Grid<std::uint8_t> rasterize(const World& world, double resolution, const Box& box, const Work& work = {});

/// The same over the bounds of the world.
Grid<std::uint8_t> rasterize(const World& world, double resolution);

}  // namespace meander
