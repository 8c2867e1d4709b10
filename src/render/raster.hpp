// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/fields.hpp"
#include "grid/image_file.hpp"
#include "render/draw_list.hpp"

namespace meander {

struct PictureSize {
  int width = 1200;
  int height = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PictureSize>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"width", "px", "width of the picture", 1, 16384}, o.width);
  visit(Field{"height", "px", "largest height of the picture; 0: as the view needs", 0, 16384}, o.height);
}

/// RGB picture of the list with smooth edges. The picture is as large as the size allows without distorting the view.
/// Throws ArgumentError when the size is out of range or takes more than 25 million pixels.
Image raster(const DrawList& list, const PictureSize& size = {});

}  // namespace meander
