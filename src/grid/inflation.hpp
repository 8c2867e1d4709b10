// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>

#include "grid/grid.hpp"

namespace meander {

/// Squared distance from every cell's centre to the nearest centre of a cell that is not 0, in cells, exactly;
/// kNothingNear where there is none.
Grid<std::int32_t> squared_distance_cells(const Grid<std::uint8_t>& occupied);
inline constexpr std::int32_t kNothingNear = 0x7fffffff;

/// 1 where the cell's centre is within `radius` [m] of the centre of a cell that is not 0, else 0.
Grid<std::uint8_t> inflated(const Grid<std::uint8_t>& occupied, double radius);

}  // namespace meander
