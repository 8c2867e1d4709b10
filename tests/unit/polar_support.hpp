// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <queue>
#include <vector>

#include "base/random.hpp"
#include "polar/polar_solver.hpp"

namespace meander {

/// Walls of points around the centre, none nearer than the robot's radius.
inline std::vector<Vec2> random_points(std::uint64_t seed, double scope = 2.54) {
  Stream random(seed, "polar points");
  std::vector<Vec2> points;
  for (int wall = 0; wall < 5; ++wall) {
    const double angle = random.uniform(-kPi, kPi), distance = random.uniform(0.4, 2.3),
                 along = random.uniform(-kPi, kPi);
    const Vec2 from = distance * Vec2(sin_cos(angle).cos, sin_cos(angle).sin);
    const Vec2 way(sin_cos(along).cos, sin_cos(along).sin);
    for (int k = 0; k < 15; ++k) points.push_back(from + (0.08 * k + random.normal(0, 0.02)) * way);
  }
  std::erase_if(points, [&](const Vec2& p) { return p.norm() < 0.28 || p.norm() > scope; });
  return points;
}

inline Projection projected(const PolarLayout& layout, const std::vector<Vec2>& points,
                            const std::vector<double>& radii = {0.3167}) {
  Projection projection(layout, radii);
  for (const Vec2& point : points) projection.add(point);
  return projection;
}

/// Ways from the target unit over the free units of a polar grid and its diagonals, by Dijkstra: ring after ring within
/// a sector.
inline std::vector<double> geodesics(const PolarLayout& layout, const ObstructedUnits& obstructed, int target) {
  const int n = layout.rings(), m = layout.sectors();
  std::vector<double> ways(static_cast<std::size_t>(n * m), 1e9);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.push({0, target});
  ways[static_cast<std::size_t>(target)] = 0;
  while (!open.empty()) {
    const auto [way, unit] = open.top();
    open.pop();
    if (way > ways[static_cast<std::size_t>(unit)]) continue;
    const int ring = unit % n, sector = unit / n;
    for (int dr = -1; dr <= 1; ++dr)
      for (int ds = -1; ds <= 1; ++ds) {
        const int r = ring + dr, s = layout.wrapped(sector + ds), next = s * n + r;
        if (r < 0 || r >= n || obstructed.test(r, s)) continue;
        const double longer = way + (layout.position(r, s) - layout.position(ring, sector)).norm();
        if (longer >= ways[static_cast<std::size_t>(next)]) continue;
        ways[static_cast<std::size_t>(next)] = longer;
        open.push({longer, next});
      }
  }
  return ways;
}

}  // namespace meander
