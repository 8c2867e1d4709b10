// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "grid/grid.hpp"
#include "render/draw_list.hpp"

namespace meander {

/// A grid of probabilities: floor where free, wall where occupied, shades between them, and a colour of its own where
/// nothing is known (0.5). Characters: blank, # and dots. `robot` and its pose, if any, are drawn on it; `window` is a
/// frame, the local map within the global one.
DrawList draw_map(const Grid<float>& probability, const std::optional<Box>& window, const std::optional<Disc>& robot,
                  double heading);

}  // namespace meander
