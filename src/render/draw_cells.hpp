// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>

#include "grid/grid.hpp"
#include "grid/image_file.hpp"
#include "render/draw_list.hpp"
#include "render/theme.hpp"

namespace meander {

/// Adds a byte map, 0 floor ... 255 wall. Values from `wall_from` on count as walls where a terminal has no colours.
void draw_grid(DrawList& list, const Grid<std::uint8_t>& grid, const Theme& theme, std::uint8_t wall_from = 128);

/// The image as a list of cells, one metre each: for the terminal, and as a layer under other things.
DrawList draw_image(const Image& image);

}  // namespace meander
