// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/shape_index.hpp"

namespace meander {

/// The first piece on a ray, found by showing it pieces in any order. Of equally near ones the lowest owner counts,
/// then the wall met most squarely, so that the order does not matter.
class NearestHit {
 public:
  /// `direction` is a unit vector.
  NearestHit(const Vec2& origin, const Vec2& direction, double max_range)
      : origin_(origin), direction_(direction), range_(max_range) {}

  /// A wall with its ends relative to the origin.
  void meet_wall(const Vec2& a, const Vec2& b, std::uint32_t owner) {
    const double side_a = cross(direction_, a), side_b = cross(direction_, b);
    if (side_a * side_b <= 0) meet_straddling(a, b, side_a, side_b, owner);
  }

  /// The same for a wall whose ends are known to lie on different sides of the ray's line, or on it.
  void meet_straddling(const Vec2& a, const Vec2& b, double side_a, double side_b, std::uint32_t owner) {
    const double along_a = direction_.dot(a), along_b = direction_.dot(b);
    const double rise = side_b - side_a;
    double range = (along_a * side_b - along_b * side_a) / rise;
    if (rise == 0) {  // seen end on: its nearer end, or the origin when that lies on it
      const double low = std::min(along_a, along_b), high = std::max(along_a, along_b);
      range = high >= 0 ? std::max(low, 0.0) : high;
    }
    take(range, std::abs(rise), b - a, owner);
  }

  void meet_pole(const Disc& disc, std::uint32_t owner) {
    const Vec2 c = disc.center - origin_;
    const double aside = cross(direction_, c), along = direction_.dot(c);
    if (std::abs(aside) > disc.radius) return;
    const double half_chord = std::sqrt(disc.radius * disc.radius - aside * aside);
    const double range = along - half_chord >= 0 ? along - half_chord : along + half_chord;
    take(range, half_chord, {disc.radius, 0}, owner);
  }

  /// Range of the nearest piece so far; max_range before any.
  double range() const { return range_; }

  std::optional<RayHit> hit() const {
    if (!found_) return std::nullopt;
    return RayHit{range_, origin_ + range_ * direction_, std::min(1.0, rise_ / extent_.norm()), owner_};
  }

 private:
  /// cos(incidence) = rise / |extent|.
  void take(double range, double rise, const Vec2& extent, std::uint32_t owner) {
    if (!(range >= 0 && range <= range_)) return;
    if (found_ && range == range_ && !beats(rise, extent, owner)) return;
    range_ = range, rise_ = rise, extent_ = extent, owner_ = owner, found_ = true;
  }
  bool beats(double rise, const Vec2& extent, std::uint32_t owner) const {
    return owner != owner_ ? owner < owner_ : rise * extent_.norm() > rise_ * extent.norm();
  }

  Vec2 origin_;
  Vec2 direction_;
  double range_;
  double rise_ = 0;
  Vec2 extent_{1, 0};
  std::uint32_t owner_ = 0;
  bool found_ = false;
};

}  // namespace meander
