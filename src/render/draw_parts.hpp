// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "render/draw_list.hpp"
#include "render/theme.hpp"

namespace meander {

/// A hundredth of the view's longer side [m]: the measure of everything whose size has no meaning in the world (line
/// widths, letters).
double picture_unit(const Box& view);

/// 1, 2 or 5 times a power of ten, the largest not above `most`; most > 0.
double round_length(double most);

/// The run of points cut into dashes of `dash` metres with equal gaps; whole when that would be more than 1000 dashes.
void draw_dashed(DrawList& list, const std::vector<Vec2>& points, bool closed, double dash, double width, Color color,
                 Mark mark);

}  // namespace meander
