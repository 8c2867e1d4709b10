// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/free_ways.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

constexpr double kContact = 1e-3;  ///< points within the body count as touched from so far outside [m]

}  // namespace

FreeWays::FreeWays(int directions, double reach)
    : step_(2 * kPi / directions), reach_(reach), ways_(static_cast<std::size_t>(directions), reach) {}

void FreeWays::look(const std::vector<Vec2>& points, double radius, double first_bearing) {
  first_ = first_bearing;
  std::fill(ways_.begin(), ways_.end(), reach_);
  for (const Vec2& point : points) shorten(point, radius);
}

/// The directions in which the disc would touch the point, and after which way.
void FreeWays::shorten(const Vec2& point, double radius) {
  const double distance = point.norm(), touch = std::min(radius, distance - kContact);
  const double bearing = angle_between(first_, angle_of(point.y(), point.x()));
  const double half = angle_of(touch, std::sqrt(distance * distance - touch * touch));
  const int first = static_cast<int>(std::ceil((bearing - half) / step_));
  const int last = static_cast<int>(std::floor((bearing + half) / step_));
  for (int k = first; k <= last; ++k) {
    const SinCos off = sin_cos(k * step_ - bearing);
    const double beside = distance * off.sin;
    const double way = distance * off.cos - std::sqrt(std::max(0.0, touch * touch - beside * beside));
    ways_[at(k)] = std::min(ways_[at(k)], std::max(0.0, way));
  }
}

Vec2 FreeWays::place(int k, double way) const {
  const SinCos t = sin_cos(bearing(k));
  return {way * t.cos, way * t.sin};
}

int FreeWays::nearest(double bearing) const {
  return static_cast<int>(std::floor(angle_between(first_, bearing) / step_ + 0.5));
}

}  // namespace meander
