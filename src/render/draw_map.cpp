// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_map.hpp"

#include <cmath>

#include "base/error.hpp"
#include "render/theme.hpp"

namespace meander {
namespace {

constexpr float kAboutUnknown = 0.05F;  ///< probabilities so near to 0.5 are drawn as unknown
constexpr double kRim = 0.04;           ///< around the map, as a share of its longer side

struct Shade {
  Color color;
  Mark mark;
};

/// Pale blue tells unknown from the greys between free and occupied.
Shade shade(float p, const Theme& colors) {
  if (std::abs(p - 0.5F) <= kAboutUnknown) return {{188, 205, 222}, Mark::cell};
  const Mark mark = p > 0.5F ? Mark::wall : Mark::ground;
  return {mixed(colors.floor, colors.wall, static_cast<double>(p)), mark};
}

}  // namespace

DrawList draw_map(const Grid<float>& probability, const std::optional<Box>& window, const std::optional<Disc>& robot,
                  double heading) {
  if (probability.cells().empty()) fail("the map is empty: it has not taken in any scan yet");
  const Theme& colors = theme(Background::light);
  const Vec2 low = probability.frame.origin.position();
  const Vec2 size = probability.frame.resolution * Vec2(probability.width(), probability.height());
  const Vec2 rim = Vec2::Constant(kRim * size.maxCoeff());
  DrawList list;
  list.view = {low - rim, low + size + rim};
  list.background = colors.background;
  DrawCells cells{
      probability.frame.origin, probability.frame.resolution, probability.width(), probability.height(), {}, {}};
  for (const float p : probability.cells()) {
    const Shade drawn = shade(p, colors);
    cells.colors.push_back(drawn.color);
    cells.marks.push_back(drawn.mark);
  }
  list.items.emplace_back(std::move(cells));
  if (window) {
    list.view.low = list.view.low.cwiseMin(window->low - rim);
    list.view.high = list.view.high.cwiseMax(window->high + rim);
    list.items.emplace_back(DrawPolyline{
        {window->low, {window->high.x(), window->low.y()}, window->high, {window->low.x(), window->high.y()}},
        true,
        0.004 * size.maxCoeff(),
        colors.path,
        Mark::curve});
  }
  if (robot) list.items.emplace_back(DrawBody{*robot, heading, colors.robot, colors.robot_nose});
  return list;
}

}  // namespace meander
