// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/geodesic_field.hpp"

#include <algorithm>

#include "indicator/cell_moves.hpp"

namespace meander {
namespace {

constexpr int kParts = 4;      ///< a step in the open costs so many of its parts where room counts
constexpr int kMost = 28;      ///< a step in a crowd at most
constexpr int kCrowding = 40;  ///< and more by so many where all around is closed
constexpr int kOn = 40;        ///< it goes on for so many steps in the open when it has come where it was to come

}  // namespace

void GeodesicField::clear() {
  width_ = height_ = 0;
  reached_.clear();
}

/// What lies within reach of the starts and in the map.
void GeodesicField::make_room(const ConfigurationSpace& space, std::span<const Cell> starts, int reach) {
  Cell low{space.width(), space.height()}, high{-1, -1};
  for (const Cell start : starts) {
    low = {std::min(low.x, start.x - reach), std::min(low.y, start.y - reach)};
    high = {std::max(high.x, start.x + reach), std::max(high.y, start.y + reach)};
  }
  low_ = {std::max(low.x, 0), std::max(low.y, 0)};
  width_ = std::max(std::min(high.x, space.width() - 1) - low_.x + 1, 0);
  height_ = std::max(std::min(high.y, space.height() - 1) - low_.y + 1, 0);
  steps_.assign(index(0, height_), -1);
  reached_.clear();
}

void GeodesicField::spread(const ConfigurationSpace& space, std::span<const Cell> starts, double limit, bool unknown,
                           WayCost cost, const Grid<std::uint8_t>* closed, std::optional<Cell> until) {
  const bool room = cost == WayCost::room;
  const int open = room ? kParts : 1, round = kDiagonal * (room ? kMost : 1) + 1;  // no step is longer than the queue
  unit_ = space.resolution() / (kStraight * open);
  int most = static_cast<int>(std::min(limit / unit_, 1e8));
  const int reach = std::min(most / (kStraight * open) + 1, std::max(space.width(), space.height()));
  make_room(space, starts, reach);
  buckets_.resize(static_cast<std::size_t>(std::max(round, static_cast<int>(buckets_.size()))));
  const auto passable = [&](Cell cell) {
    return (unknown ? space.open(cell) : space.free(cell)) && !(closed && closed->at(cell, 1));
  };
  const auto passes = [&](Cell cell) { return steps_at(cell) >= 0 || passable(cell); };  // what is reached does
  const auto parts = [&](Cell cell) { return room ? std::min(kMost, open + space.crowded(cell, kCrowding)) : 1; };
  int waiting = 0;
  for (const Cell start : starts) {
    if (!passable(start)) continue;
    steps(start) = 0;
    buckets_[0].push_back(start);
    ++waiting;
  }
  for (int now = 0; waiting > 0; ++now) {
    std::vector<Cell>& bucket = buckets_[static_cast<std::size_t>(now % round)];
    for (const Cell cell : bucket) {  // steps lead to other buckets
      --waiting;
      if (steps(cell) != now || now > most) continue;  // a shorter way came later
      reached_.push_back(cell);
      if (cell == until) most = std::min(most, now + kOn * kStraight * open);
      for (const CellMove& move : kCellMoves) {
        const Cell next{cell.x + move.dx, cell.y + move.dy};
        const int known = steps_at(next);
        if ((known >= 0 && known <= now + move.length * open) || !passes(next)) continue;
        const int way = now + move.length * parts(next);
        if (way > most) continue;
        if (move.length == kDiagonal && !(passes({cell.x, next.y}) && passes({next.x, cell.y}))) continue;
        if (known >= 0 && known <= way) continue;
        steps(next) = way;
        buckets_[static_cast<std::size_t>(way % round)].push_back(next);
        ++waiting;
      }
    }
    bucket.clear();
  }
}

}  // namespace meander
