// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cmath>

#include "geometry/vec.hpp"

namespace meander {

inline double squared_distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a, e = point - a;
  const double t = std::clamp(e.dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (e - t * d).squaredNorm();
}

/// How the edge a -> b changes the winding number along the ray from `point` towards +x: +1 when it crosses upwards, -1
/// downwards, else 0. An edge owns its lower end, so that a ray through a vertex counts it once.
inline int winding_step(const Vec2& point, const Vec2& a, const Vec2& b) {
  if ((a.y() <= point.y()) == (b.y() <= point.y())) return 0;
  const bool upwards = a.y() <= point.y();
  const double side = cross(b - a, point - a);
  return (upwards ? side > 0 : side < 0) ? (upwards ? 1 : -1) : 0;
}

}  // namespace meander
