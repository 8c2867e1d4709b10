// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/correlation.hpp"

#include <algorithm>
#include <cmath>

namespace meander::topology {

void senses_of(const SenseRings& rings, double heading, std::span<float> row) {
  turn_ring(rings.touch, -heading, row.first(rings.touch.size()));
  turn_ring(rings.light, -heading, row.subspan(rings.touch.size(), rings.light.size()));
}

Correlation::Correlation(const CorrelationOptions& options, const SenseMetric& metric)
    : options_(options),
      metric_(metric),
      turned_(static_cast<std::size_t>((2 * options.turns + 1) * metric.stride())) {}

void Correlation::turn_senses(const SenseRings& rings, double heading) {
  const auto stride = static_cast<std::size_t>(metric_.stride());
  for (int turn = -options_.turns; turn <= options_.turns; ++turn)
    senses_of(rings, heading + turn * options_.turn_step,
              std::span(turned_).subspan(static_cast<std::size_t>(turn + options_.turns) * stride, stride));
}

Correction Correlation::correct(const GrowingNet& net, const Pose2& pose, const SenseRings& rings,
                                std::int64_t sample) {
  // [Z+] Of the cells that are not fresh and may be meant, the one most like what is sensed now, under some heading.
  turn_senses(rings, pose.heading);
  const Vec2 here = pose.position();
  const double per_reach = 1 / (options_.reach * options_.reach);
  double best = options_.accept * options_.accept;
  int best_turn = 0;
  Correction found;
  net.around(here, options_.reach, [&](int cell) {
    const Cell& candidate = net.cells()[cell];
    const double apart = (candidate.position - here).squaredNorm() * per_reach;
    if (apart > std::min(best, 1.0) || sample - candidate.born < options_.age) return;
    for (int turn = -options_.turns; turn <= options_.turns; ++turn) {
      const double base = apart + options_.turn_cost * turn * turn;
      if (base > best) continue;
      const float* row = turned_.data() + (turn + options_.turns) * metric_.stride();
      const double cost = base + metric_.squared(net.cells().senses(cell), row);
      if (cost > best || (cost == best && found.cell >= 0 && cell > found.cell)) continue;
      best = cost;
      best_turn = turn;
      found.cell = cell;
    }
  });
  if (found.cell < 0) return found;
  const Vec2 way = net.cells()[found.cell].position - here;
  const double length = way.norm();
  if (length > options_.dead_zone) found.shift = options_.gain * (length - options_.dead_zone) / length * way;
  found.turn = options_.turn_gain * best_turn * options_.turn_step;
  found.distance = std::sqrt(best);
  return found;
}

}  // namespace meander::topology
