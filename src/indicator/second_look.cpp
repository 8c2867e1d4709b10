// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/second_look.hpp"

#include <algorithm>
#include <cmath>

#include "indicator/grid_way.hpp"

namespace meander {
namespace {

constexpr std::size_t kBeyond = 6;  ///< cells: so far into the unknown, for standing still shows nothing new
constexpr double kStands = 0.5;     ///< a robot in a cell that is blocked stands in one so far away [m]

}  // namespace

std::optional<Vec2> SecondLook::next(SonarOccupancy& map, const Vec2& at, const Vec2& goal, double arrive) {
  close(map.space(), count());
  std::vector<Cell> way = way_over(map.space(), at, goal, arrive);
  if (way.empty()) way = way_over(map.without_weak(), at, goal, arrive);
  if (way.empty()) return std::nullopt;
  return look(map, way).value_or(goal);
}

/// Empty: none leads there.
std::vector<Cell> SecondLook::way_over(const ConfigurationSpace& space, const Vec2& at, const Vec2& goal,
                                       double arrive) {
  field_.spread(space, cells_at(space, goal, arrive, true), 1e9, true, WayCost::length, &closed_);
  const auto from = nearest_reached(space, field_, at, kStands);
  return from ? way_down(field_, *from) : std::vector<Cell>{};
}

/// Where the way leaves what is known; none: nowhere.
std::optional<Vec2> SecondLook::look(SonarOccupancy& map, const std::vector<Cell>& way) {
  const GridFrame& frame = map.space().frame();
  const auto cell = std::find_if(way.begin(), way.end(), [&](Cell c) { return !map.space().free(c); });
  if (cell == way.end()) return std::nullopt;
  looked_.push_back(frame.center(*cell));
  const int reach = static_cast<int>(map.reach() / frame.resolution) + 1;
  for (int y = cell->y - reach; y <= cell->y + reach; ++y)
    for (int x = cell->x - reach; x <= cell->x + reach; ++x)
      if (map.weak({x, y})) map.forget({x, y});
  const auto left = static_cast<std::size_t>(way.end() - 1 - cell);
  return frame.center(*(cell + static_cast<std::ptrdiff_t>(std::min(kBeyond, left))));
}

const Grid<std::uint8_t>& SecondLook::close(const ConfigurationSpace& map, int looks) {
  constexpr double kSame = 0.2;  // looks at places nearer than this are looks at the same [m]
  if (closed_.width() == map.width() && closed_.height() == map.height())
    closed_.cells().assign(closed_.cells().size(), 0);
  else
    closed_ = Grid<std::uint8_t>(map.width(), map.height(), 0);
  const GridFrame& frame = map.frame();
  const int far = static_cast<int>(kSame / frame.resolution) + 1;
  for (std::size_t i = first_; i < static_cast<std::size_t>(std::max(looks, 0)); ++i) {
    const Vec2& place = looked_[i];
    const Cell at = frame.cell(place);
    for (int y = at.y - far; y <= at.y + far; ++y)
      for (int x = at.x - far; x <= at.x + far; ++x)
        if (closed_.contains({x, y}) && !map.free({x, y}) && (frame.center({x, y}) - place).norm() < kSame)
          closed_[{x, y}] = 1;
  }
  return closed_;
}

}  // namespace meander
