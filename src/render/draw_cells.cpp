// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_cells.hpp"

#include "base/error.hpp"

namespace meander {

void draw_grid(DrawList& list, const Grid<std::uint8_t>& grid, const Theme& theme, std::uint8_t wall_from) {
  const auto colors = map_colors(theme);
  DrawCells cells{grid.frame.origin, grid.frame.resolution, grid.width(), grid.height(), {}, {}};
  cells.colors.reserve(grid.cells().size());
  cells.marks.reserve(grid.cells().size());
  for (const std::uint8_t value : grid.cells()) {
    cells.colors.push_back(colors[value]);
    cells.marks.push_back(value >= wall_from ? Mark::wall : Mark::cell);
  }
  list.items.push_back(std::move(cells));
}

DrawList draw_image(const Image& image) {
  DrawCells cells{{}, 1, image.width, image.height, {}, {}};
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto row_bytes = static_cast<std::size_t>(image.width) * channels;
  if (image.pixels.size() != row_bytes * static_cast<std::size_t>(image.height) || channels < 1 || channels == 2 ||
      channels > 4)
    fail("draw_image: 1, 3 or 4 channels and width x height pixels expected, got {} channels and {} bytes",
         image.channels, image.pixels.size());
  for (int row = image.height - 1; row >= 0; --row)
    for (int column = 0; column < image.width; ++column) {
      const std::uint8_t* p =
          &image.pixels[static_cast<std::size_t>(row) * row_bytes + static_cast<std::size_t>(column) * channels];
      cells.colors.push_back(channels == 1 ? Color{p[0], p[0], p[0]}
                                           : Color{p[0], p[1], p[2], channels == 4 ? p[3] : std::uint8_t{255}});
    }
  DrawList list;
  list.view = {{0, 0}, {static_cast<double>(image.width), static_cast<double>(image.height)}};
  list.items.push_back(std::move(cells));
  return list;
}

}  // namespace meander
