// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/geodesic_field.hpp"

#include <algorithm>

namespace meander {
namespace {

constexpr int kStraight = 5, kDiagonal = 7;
constexpr int kBuckets = kDiagonal + 1;  ///< of a round queue: no step is longer

struct Move {
  int dx, dy, steps;
};
constexpr Move kMoves[] = {{1, 0, kStraight}, {0, 1, kStraight},  {-1, 0, kStraight},  {0, -1, kStraight},
                           {1, 1, kDiagonal}, {-1, 1, kDiagonal}, {-1, -1, kDiagonal}, {1, -1, kDiagonal}};

}  // namespace

void GeodesicField::spread(const ConfigurationSpace& space, Cell start, double limit, bool unknown) {
  unit_ = space.resolution() / kStraight;
  const int most = static_cast<int>(std::min(limit / unit_, 1e8));
  const int reach = std::min(most / kStraight + 1, std::max(space.width(), space.height()));
  low_ = {start.x - reach, start.y - reach};
  side_ = 2 * reach + 1;
  steps_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), -1);
  buckets_.resize(kBuckets);
  reached_.clear();
  const auto passable = [&](Cell cell) {
    return space.free(cell) || (unknown && space.open(cell) && space.known(cell) == Known::nothing);
  };
  if (!passable(start)) return;
  steps(start) = 0;
  buckets_[0].push_back(start);
  int waiting = 1;
  for (int now = 0; waiting > 0; ++now) {
    std::vector<Cell>& bucket = buckets_[static_cast<std::size_t>(now % kBuckets)];
    for (const Cell cell : bucket) {  // steps lead to other buckets
      --waiting;
      if (steps(cell) != now || now > most) continue;  // a shorter way came later
      reached_.push_back(cell);
      for (const Move& move : kMoves) {
        const Cell next{cell.x + move.dx, cell.y + move.dy};
        const int way = now + move.steps;
        if (way > most || !passable(next)) continue;
        if (move.steps == kDiagonal && !(passable({cell.x, next.y}) && passable({next.x, cell.y}))) continue;
        if (steps_at(next) >= 0 && steps_at(next) <= way) continue;
        steps(next) = way;
        buckets_[static_cast<std::size_t>(way % kBuckets)].push_back(next);
        ++waiting;
      }
    }
    bucket.clear();
  }
}

}  // namespace meander
