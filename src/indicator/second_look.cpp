// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/second_look.hpp"

#include <algorithm>
#include <cmath>

#include "indicator/grid_way.hpp"

namespace meander {
namespace {

constexpr std::size_t kBeyond = 6;  ///< cells: so far into the unknown, for standing still shows nothing new
constexpr double kSame = 0.15;      ///< two looks at places nearer than this are looks at the same [m]

}  // namespace

std::optional<Vec2> SecondLook::next(SonarOccupancy& map, Cell from, Cell goal) {
  constexpr int kMost = 1000;
  for (int i = 0; i < kMost; ++i) {
    bool closed = false;
    for (const bool doubt : {false, true}) {
      const ConfigurationSpace space = doubt ? map.without_weak() : map.space();
      field_.spread(space, goal, 1e9, true);
      if (!std::isfinite(field_.at(from))) continue;
      if (const auto place = along(map, space, from, goal)) return place;
      closed = true;
      break;
    }
    if (!closed) return std::nullopt;
  }
  return std::nullopt;
}

/// None: the way leads where the robot has looked before, and is closed there now.
std::optional<Vec2> SecondLook::along(SonarOccupancy& map, const ConfigurationSpace& space, Cell from, Cell goal) {
  const std::vector<Cell> way = way_down(field_, from);
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Cell cell = way[i];
    if (map.space().free(cell)) continue;
    const Vec2 place = map.space().frame().center(cell);
    if (looked_at(place)) {
      close(map, cell);
      return std::nullopt;
    }
    looked_.push_back(place);
    const int reach = static_cast<int>(map.reach() / space.resolution()) + 1;
    for (int y = cell.y - reach; y <= cell.y + reach; ++y)
      for (int x = cell.x - reach; x <= cell.x + reach; ++x)
        if (map.weak({x, y})) map.forget({x, y});
    return space.frame().center(way[std::min(i + kBeyond, way.size() - 1)]);
  }
  return space.frame().center(goal);
}

bool SecondLook::looked_at(const Vec2& place) const {
  for (const Vec2& before : looked_)
    if ((before - place).norm() < kSame) return true;
  return false;
}

void SecondLook::close(SonarOccupancy& map, Cell cell) {
  constexpr double kCertain = 30;
  map.add(cell, kCertain);
}

}  // namespace meander
