// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/goal_ways.hpp"

#include <algorithm>

namespace meander {
namespace {

constexpr int kSquare = 4;          ///< cells along a side
constexpr int kBlock = 4;           ///< squares along the side of what is looked at together
constexpr double kDetour = 1.08;    ///< a way along rows and diagonals may be so much longer than the straight one
constexpr double kRounding = 1.42;  ///< squares, at either end

}  // namespace

void GoalWays::update(const ConfigurationSpace& map, const Vec2& goal) {
  if (squares_ && version_ == map.version() && goal_ == goal) return;
  const auto in_squares = [](int cells) { return (cells + kSquare - 1) / kSquare; };
  const bool first = !squares_;
  if (first)
    squares_.emplace(in_squares(map.width()), in_squares(map.height()),
                     GridFrame{kSquare * map.resolution(), map.frame().origin}, 0.0);
  for (int top = 0; top < squares_->height(); top += kBlock)
    for (int left = 0; left < squares_->width(); left += kBlock) {
      const Cell low{left * kSquare, top * kSquare};
      const Cell high{low.x + kBlock * kSquare - 1, low.y + kBlock * kSquare - 1};
      if (!first && map.changed(low, high) <= version_) continue;
      for (int y = top; y < top + kBlock; ++y)
        for (int x = left; x < left + kBlock; ++x) look(map, {x, y});
    }
  const bool same = !first && squares_version_ == squares_->version() && goal_ == goal;
  version_ = map.version();
  squares_version_ = squares_->version();
  goal_ = goal;
  if (same) return;  // cells have changed, no square has
  field_.spread(*squares_, squares_->frame().cell(goal), 1e9);
}

/// A square is open as long as one of its cells is.
void GoalWays::look(const ConfigurationSpace& map, Cell square) {
  bool open = false;
  for (int y = square.y * kSquare; y < (square.y + 1) * kSquare && !open; ++y)
    for (int x = square.x * kSquare; x < (square.x + 1) * kSquare && !open; ++x) open = map.open({x, y});
  squares_->set(square, open ? Known::free : Known::wall);
}

double GoalWays::least(const Vec2& from) const {
  const double straight = (from - goal_).norm();
  if (field_.reached().empty()) return straight;  // what is at the goal itself has to be looked at
  const double way = field_.at(squares_->frame().cell(from));
  return std::max(straight, way / kDetour - 2 * kRounding * squares_->resolution());
}

}  // namespace meander
