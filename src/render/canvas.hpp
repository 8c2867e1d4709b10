// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <vector>

#include "grid/image_file.hpp"
#include "render/draw_list.hpp"
#include "render/viewport.hpp"

namespace meander {

/// Pixels of colour, and of what they stand for.
struct Canvas {
  Viewport viewport;
  Image image;                      ///< RGB
  std::vector<std::uint8_t> marks;  ///< the Mark on top of each pixel
  double least_width = 1;           ///< [pixels] of lines that matter; faint ones (grid, open doors) may have 1
  bool smooth = true;               ///< soften edges; false: every pixel belongs to one item
  bool lettered = true;             ///< paint texts
  double least_body = 0;            ///< [pixels] radius from which bodies show their heading
};

Canvas blank_canvas(const Viewport& viewport, int width, int height, Color background);

/// Paints all items in painting order.
void paint(Canvas& canvas, const DrawList& list);

}  // namespace meander
