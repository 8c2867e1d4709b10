// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "geometry/vec.hpp"

namespace meander {

/// From world metres (y up) to picture units (y down), the same scale along both axes.
struct Viewport {
  Vec2 corner{0, 0};  ///< world point of the picture's upper left corner
  double scale = 1;   ///< picture units per metre
  double width = 0;   ///< of the picture in its own units
  double height = 0;

  Vec2 operator()(const Vec2& world) const {
    return {(world.x() - corner.x()) * scale, (corner.y() - world.y()) * scale};
  }
  Vec2 world(const Vec2& picture) const { return {corner.x() + picture.x() / scale, corner.y() - picture.y() / scale}; }
};

/// The view with both sides at least a billionth of its coordinates, so that it can be scaled. Throws ArgumentError
/// when it is not finite or upside down.
Box usable_view(const Box& view);

/// The largest picture of the view within width x height.
Viewport fit(const Box& view, double width, double height);

}  // namespace meander
