// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <Eigen/Core>
#include <vector>

namespace meander {

/// A point or direction in the plane [m]. World frame unless a name says otherwise (x forward or east, y left or
/// north).
using Vec2 = Eigen::Vector2d;

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// a turned by +90 degrees.
inline Vec2 left_of(const Vec2& a) { return {-a.y(), a.x()}; }

/// Axis-aligned box; empty when low > high.
struct Box {
  Vec2 low{0, 0};
  Vec2 high{0, 0};
  bool contains(const Vec2& p) const {
    return p.x() >= low.x() && p.y() >= low.y() && p.x() <= high.x() && p.y() <= high.y();
  }
  Vec2 size() const { return high - low; }
  Vec2 center() const { return 0.5 * (low + high); }
  bool operator==(const Box&) const = default;
};

}  // namespace meander
