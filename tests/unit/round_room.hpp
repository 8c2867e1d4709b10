// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cmath>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "topology/topologic_map.hpp"

namespace meander::topology {

/// A robot in a round room of radius 3 m with two lamps: whiskers touch the wall, lights see the lamps. Its odometry is
/// right.
class RoundRoom {
 public:
  explicit RoundRoom(std::uint64_t seed) : stream_(seed, "walk") {
    seen_.readings.whisker.resize(24);
    seen_.readings.light.resize(24);
    seen_.period = 0.2;
  }
  const Observation& next() {
    heading_ += stream_.normal(0, 0.2);
    const Vec2 at = seen_.odometry.pose.position();
    if (at.norm() > 2.7) heading_ = angle_of(-at.y(), -at.x()) + stream_.uniform(-1, 1);
    const SinCos t = sin_cos(wrap_angle(heading_));
    seen_.odometry.pose.x += 0.05 * t.cos;
    seen_.odometry.pose.y += 0.05 * t.sin;
    seen_.time += 0.2;
    for (int i = 0; i < 24; ++i) {
      const SinCos whisker = sin_cos(i * kPi / 12);
      const Vec2 tip = seen_.odometry.pose.position() + 0.3 * Vec2(whisker.cos, whisker.sin);
      seen_.readings.whisker[static_cast<std::size_t>(i)] = stream_.chance(tip.norm() > 2.9 ? 0.98 : 0.01);
      double light = 0;
      for (const Vec2& lamp : {Vec2(0, 0), Vec2(2, 1.5)}) {
        const Vec2 way = lamp - seen_.odometry.pose.position();
        const SinCos off = sin_cos(angle_of(way.y(), way.x()) - i * kPi / 12);
        light += std::max(0.0, off.cos) / (1 + 0.3 * way.squaredNorm());
      }
      seen_.readings.light[static_cast<std::size_t>(i)] = light;
    }
    return seen_;
  }

 private:
  Stream stream_;
  Observation seen_;
  double heading_ = 0;
};

inline TopologicMap fresh_map() { return {TopologicMapOptions{}, SenseSuite{}}; }

}  // namespace meander::topology
