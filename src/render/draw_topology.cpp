// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_topology.hpp"

namespace meander {
namespace {

constexpr double kPlace = 0.04, kWinner = 0.09;  ///< radii [m]
constexpr double kLink = 0.03;                   ///< [m]
constexpr double kRim = 0.5;                     ///< around the map [m]

}  // namespace

void draw_topology(DrawList& list, const topology::TopologicMap& map, const Theme& theme) {
  const topology::CellPool& cells = map.net().cells();
  for (int cell = 0; cell < cells.slots(); ++cell)
    for (const topology::Link& link : cells[cell].links) {
      if (link.to < cell) continue;  // each once
      const Color color = link.suspended ? theme.contact : mixed(theme.grid, theme.path, 0.25 + 0.75 * link.weight);
      list.items.emplace_back(
          DrawPolyline{{cells[cell].position, cells[link.to].position}, false, kLink, color, Mark::path});
    }
  for (int cell = 0; cell < cells.slots(); ++cell)
    if (cells[cell].alive())
      list.items.emplace_back(
          cell == map.net().winner()
              ? DrawDisc{{cells[cell].position, kWinner}, theme.start, Mark::start}
              : DrawDisc{{cells[cell].position, kPlace}, mixed(theme.path, theme.wall, 0.5), Mark::place});
  if (map.samples() > 0)
    list.items.emplace_back(DrawBody{
        {map.pose().position(), map.suite().whisker_radius}, map.pose().heading, theme.robot, theme.robot_nose});
}

DrawList draw_topology(const topology::TopologicMap& map) {
  const topology::CellPool& cells = map.net().cells();
  const Theme& colors = theme(Background::light);
  DrawList list;
  list.background = colors.background;
  Box box{map.pose().position(), map.pose().position()};
  for (int cell = 0; cell < cells.slots(); ++cell) {
    if (!cells[cell].alive()) continue;
    box.low = box.low.cwiseMin(cells[cell].position);
    box.high = box.high.cwiseMax(cells[cell].position);
  }
  list.view = {box.low - Vec2(kRim, kRim), box.high + Vec2(kRim, kRim)};
  const Vec2 &a = list.view.low, &b = list.view.high;
  list.items.emplace_back(DrawArea{{{a, {b.x(), a.y()}, b, {a.x(), b.y()}}, {}}, colors.floor, Mark::ground});
  draw_topology(list, map, colors);
  return list;
}

}  // namespace meander
