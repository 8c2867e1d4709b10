// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/geodesic_field.hpp"

#include <algorithm>

namespace meander {
namespace {

constexpr int kStraight = 5, kDiagonal = 7;
constexpr int kParts = 4;      ///< a step in the open costs so many of its parts where room counts
constexpr int kMost = 28;      ///< a step in a crowd at most
constexpr int kCrowding = 40;  ///< and more by so many where all around is closed

struct Move {
  int dx, dy, steps;
};
constexpr Move kMoves[] = {{1, 0, kStraight}, {0, 1, kStraight},  {-1, 0, kStraight},  {0, -1, kStraight},
                           {1, 1, kDiagonal}, {-1, 1, kDiagonal}, {-1, -1, kDiagonal}, {1, -1, kDiagonal}};

}  // namespace

void GeodesicField::spread(const ConfigurationSpace& space, Cell start, double limit, bool unknown, WayCost cost) {
  const bool room = cost == WayCost::room;
  const int open = room ? kParts : 1, round = kDiagonal * (room ? kMost : 1) + 1;  // no step is longer than the queue
  unit_ = space.resolution() / (kStraight * open);
  const int most = static_cast<int>(std::min(limit / unit_, 1e8));
  const int reach = std::min(most / (kStraight * open) + 1, std::max(space.width(), space.height()));
  low_ = {start.x - reach, start.y - reach};
  side_ = 2 * reach + 1;
  steps_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), -1);
  buckets_.resize(static_cast<std::size_t>(std::max(round, static_cast<int>(buckets_.size()))));
  reached_.clear();
  const auto passable = [&](Cell cell) { return space.free(cell) || (unknown && space.open(cell)); };
  const auto parts = [&](Cell cell) { return room ? std::min(kMost, open + space.crowded(cell, kCrowding)) : 1; };
  if (!passable(start)) return;
  steps(start) = 0;
  buckets_[0].push_back(start);
  int waiting = 1;
  for (int now = 0; waiting > 0; ++now) {
    std::vector<Cell>& bucket = buckets_[static_cast<std::size_t>(now % round)];
    for (const Cell cell : bucket) {  // steps lead to other buckets
      --waiting;
      if (steps(cell) != now || now > most) continue;  // a shorter way came later
      reached_.push_back(cell);
      for (const Move& move : kMoves) {
        const Cell next{cell.x + move.dx, cell.y + move.dy};
        if (!passable(next)) continue;
        const int way = now + move.steps * parts(next);
        if (way > most) continue;
        if (move.steps == kDiagonal && !(passable({cell.x, next.y}) && passable({next.x, cell.y}))) continue;
        if (steps_at(next) >= 0 && steps_at(next) <= way) continue;
        steps(next) = way;
        buckets_[static_cast<std::size_t>(way % round)].push_back(next);
        ++waiting;
      }
    }
    bucket.clear();
  }
}

}  // namespace meander
