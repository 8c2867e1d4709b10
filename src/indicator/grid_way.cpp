// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/grid_way.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// The cell around a place with the least distance of those that pass.
template <class Pass>
std::optional<Cell> nearest(const ConfigurationSpace& space, const Vec2& at, double within, Pass pass) {
  const Cell here = space.frame().cell(at);
  if (pass(here)) return here;
  const int reach = static_cast<int>(within / space.resolution());
  std::optional<Cell> best;
  double least = within;
  for (int y = here.y - reach; y <= here.y + reach; ++y)
    for (int x = here.x - reach; x <= here.x + reach; ++x) {
      const double away = (space.frame().center({x, y}) - at).norm();
      if (away > least || !pass(Cell{x, y})) continue;
      least = away;
      best = Cell{x, y};
    }
  return best;
}

}  // namespace

std::vector<Cell> way_down(const GeodesicField& field, Cell from) {
  std::vector<Cell> way;
  if (!std::isfinite(field.at(from))) return way;
  for (Cell cell = from;;) {
    way.push_back(cell);
    if (field.at(cell) <= 0) return way;
    Cell best = cell;
    double steepest = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{cell.x + dx, cell.y + dy};
        // A diagonal step needs both cells beside it, as in the field.
        if (dx != 0 && dy != 0 &&
            !(std::isfinite(field.at({cell.x, next.y})) && std::isfinite(field.at({next.x, cell.y}))))
          continue;
        const double fall = (field.at(cell) - field.at(next)) / (dx != 0 && dy != 0 ? 1.4 : 1.0);
        if (fall <= steepest + 1e-9) continue;
        steepest = fall;
        best = next;
      }
    if (best == cell) return {};
    cell = best;
  }
}

std::optional<Cell> nearest_reached(const ConfigurationSpace& space, const GeodesicField& field, const Vec2& at,
                                    double within) {
  return nearest(space, at, within, [&](Cell cell) { return std::isfinite(field.at(cell)); });
}

std::optional<Cell> nearest_free(const ConfigurationSpace& space, const Vec2& at, double within) {
  return nearest(space, at, within, [&](Cell cell) { return space.free(cell); });
}

std::optional<Cell> nearest_open(const ConfigurationSpace& space, const Vec2& at, double within) {
  return nearest(space, at, within, [&](Cell cell) { return space.open(cell); });
}

std::vector<Cell> cells_at(const ConfigurationSpace& space, const Vec2& at, double within, bool unknown) {
  const auto passes = [&](Cell cell) { return unknown ? space.open(cell) : space.free(cell); };
  const Cell here = space.frame().cell(at);
  if (passes(here)) return {here};
  std::vector<Cell> cells;
  const double corner = 0.71 * space.resolution();
  const int reach = static_cast<int>(within / space.resolution()) + 1;
  for (int y = here.y - reach; y <= here.y + reach; ++y)
    for (int x = here.x - reach; x <= here.x + reach; ++x)
      if ((space.frame().center({x, y}) - at).norm() + corner <= within && passes({x, y})) cells.push_back({x, y});
  return cells;
}

bool straight_way(const ConfigurationSpace& space, Cell from, Cell to) {
  const int steps = 2 * std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  for (int i = 0; i <= steps; ++i) {
    const double share = steps == 0 ? 0 : static_cast<double>(i) / steps;
    const Cell cell{static_cast<int>(std::lround(from.x + share * (to.x - from.x))),
                    static_cast<int>(std::lround(from.y + share * (to.y - from.y)))};
    if (!space.open(cell)) return false;
  }
  return true;
}

}  // namespace meander
