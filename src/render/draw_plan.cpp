// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_plan.hpp"

#include <algorithm>
#include <cmath>

#include "render/draw_parts.hpp"

namespace meander {
namespace {

constexpr int kContours = 10, kShades = 40;

DrawList empty_picture(const GridFrame& frame, int width, int height, const Theme& theme) {
  DrawList list;
  list.background = theme.background;
  const double right = width * frame.resolution, top = height * frame.resolution;
  list.view = {frame.origin.position(), frame.origin.position()};
  for (const Vec2& corner : {Vec2(right, 0), Vec2(0, top), Vec2(right, top)}) {
    list.view.low = list.view.low.cwiseMin(frame.origin * corner);
    list.view.high = list.view.high.cwiseMax(frame.origin * corner);
  }
  return list;
}

/// The landscape seen through squares of the size of a cell, whatever the lattice.
class Landscape {
 public:
  explicit Landscape(const Plan& plan) : plan_(plan) {
    for (const double value : plan.result.value.cells())
      if (value != kNoValue) lowest_ = std::min(lowest_, value);
  }
  Cell unit(Cell square) const { return cell_at(plan_.problem.lattice, {square.x + 0.5, square.y + 0.5}); }
  double value(Cell square) const { return plan_.result.value.at(unit(square), kNoValue); }
  /// 0 farthest from the targets, 1 at them.
  double height(double value) const { return lowest_ < 0 ? 1 - value / lowest_ : 1; }
  /// The same in few steps: cells of one colour become one piece of an SVG.
  double shade(double value) const { return std::round(height(value) * kShades) / kShades; }
  int band(Cell square) const {
    const double v = value(square);
    return v == kNoValue ? -1 : static_cast<int>(height(v) * kContours);
  }
  bool on_contour(Cell square) const {
    const int here = band(square);
    if (here < 0) return false;
    return band({square.x + 1, square.y}) > here || band({square.x - 1, square.y}) > here ||
           band({square.x, square.y + 1}) > here || band({square.x, square.y - 1}) > here;
  }

 private:
  const Plan& plan_;
  double lowest_ = 0;
};

void draw_landscape(DrawList& list, const Plan& plan, const Theme& theme) {
  const Grid<std::uint8_t>& solid = plan.problem.solid();
  const Landscape landscape(plan);
  DrawCells cells{solid.frame.origin, solid.frame.resolution, solid.width(), solid.height(), {}, {}};
  const auto add = [&](Color color, Mark mark) {
    cells.colors.push_back(color);
    cells.marks.push_back(mark);
  };
  for (int y = 0; y < solid.height(); ++y)
    for (int x = 0; x < solid.width(); ++x) {
      const double value = landscape.value({x, y});
      const Color ground = value == kNoValue ? theme.floor : mixed(theme.floor, theme.light, landscape.shade(value));
      if (solid[{x, y}] != 0)
        add(theme.wall, Mark::wall);
      else if (plan.problem.blocked.at(landscape.unit({x, y}), 1) != 0)
        add(mixed(theme.floor, theme.wall, 0.35), Mark::sweep);
      else if (landscape.on_contour({x, y}))
        add(mixed(ground, theme.muted, 0.5), Mark::grid);
      else
        add(ground, Mark::ground);
    }
  list.items.push_back(std::move(cells));
}

}  // namespace

DrawList draw_planning_map(const PlanningMap& map, const Theme& theme) {
  const Grid<std::uint8_t>& solid = map.solid;
  DrawList list = empty_picture(solid.frame, solid.width(), solid.height(), theme);
  float hardest = 1;
  for (const float hard : map.difficulty.cells()) hardest = std::max(hardest, hard);
  DrawCells cells{solid.frame.origin, solid.frame.resolution, solid.width(), solid.height(), {}, {}};
  for (std::size_t i = 0; i < solid.cells().size(); ++i) {
    const double hard = map.difficulty.cells().empty() ? 1.0 : static_cast<double>(map.difficulty.cells()[i]);
    const double share = hardest > 1 ? std::max(hard - 1, 0.0) / static_cast<double>(hardest - 1) : 0;
    cells.colors.push_back(solid.cells()[i] != 0 ? theme.wall : mixed(theme.floor, theme.door, 0.6 * share));
    cells.marks.push_back(solid.cells()[i] != 0 ? Mark::wall : share > 0 ? Mark::grid : Mark::ground);
  }
  list.items.push_back(std::move(cells));
  return list;
}

DrawList draw_plan(const Plan& plan, const Theme& theme) {
  const Grid<std::uint8_t>& solid = plan.problem.solid();
  DrawList list = empty_picture(solid.frame, solid.width(), solid.height(), theme);
  draw_landscape(list, plan, theme);
  const double unit = picture_unit(list.view);
  const auto place = [&](Cell cell) { return in_metres(solid.frame, cell_center(plan.problem.lattice, cell)); };
  list.items.push_back(DrawPolyline{plan.points(), false, 0.35 * unit, theme.path, Mark::path});
  for (const Cell target : plan.problem.targets)
    list.items.push_back(DrawDisc{{place(target), unit}, theme.goal, Mark::goal});
  const double radius = plan.problem.robot_radius * solid.frame.resolution;
  if (plan.problem.start)
    list.items.push_back(
        DrawDisc{{place(*plan.problem.start), std::max(radius, unit)}, theme.start, Mark::start, 0.3 * unit});
  return list;
}

}  // namespace meander
