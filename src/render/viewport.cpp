// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/viewport.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "render/draw_list.hpp"

namespace meander {

Box usable_view(const Box& view) {
  const double reach = std::max(view.low.cwiseAbs().maxCoeff(), view.high.cwiseAbs().maxCoeff());
  if (!view.low.allFinite() || !view.high.allFinite() || reach > kDrawnReach || (view.high - view.low).minCoeff() < 0)
    fail("picture: view with finite corners, low <= high, expected, got ({}, {}) to ({}, {})", view.low.x(),
         view.low.y(), view.high.x(), view.high.y());
  const double least = std::max(1e-9, reach * 1e-9);
  const Vec2 half = (0.5 * view.size()).cwiseMax(0.5 * least);
  return {view.center() - half, view.center() + half};
}

Viewport fit(const Box& view, double width, double height) {
  const Box box = usable_view(view);
  Viewport viewport;
  viewport.scale = std::min(width / box.size().x(), height / box.size().y());
  viewport.corner = {box.low.x(), box.high.y()};
  viewport.width = box.size().x() * viewport.scale;
  viewport.height = box.size().y() * viewport.scale;
  return viewport;
}

}  // namespace meander
