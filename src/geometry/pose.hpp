// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "geometry/angle.hpp"
#include "geometry/vec.hpp"

namespace meander {

/// Position [m] and heading [rad], read as the transform from the body frame into the frame the pose is given in.
struct Pose2 {
  double x = 0;
  double y = 0;
  double heading = 0;

  Vec2 position() const { return {x, y}; }
  Vec2 direction() const {
    const SinCos t = sin_cos(heading);
    return {t.cos, t.sin};
  }
  bool operator==(const Pose2&) const = default;
};

/// frame_from_body * p: a point of the body frame in the outer frame.
inline Vec2 operator*(const Pose2& pose, const Vec2& p) {
  const SinCos t = sin_cos(pose.heading);
  return {pose.x + t.cos * p.x() - t.sin * p.y(), pose.y + t.sin * p.x() + t.cos * p.y()};
}

/// a_from_b * b_from_c = a_from_c.
inline Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
  const Vec2 p = a_from_b * b_from_c.position();
  return {p.x(), p.y(), wrap_angle(a_from_b.heading + b_from_c.heading)};
}

inline Pose2 inverse(const Pose2& pose) {
  const SinCos t = sin_cos(pose.heading);
  return {-t.cos * pose.x - t.sin * pose.y, t.sin * pose.x - t.cos * pose.y, wrap_angle(-pose.heading)};
}

}  // namespace meander
