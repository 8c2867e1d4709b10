// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sim/contact.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// Approach slower than this share of the speed is rounding, not motion.
constexpr double kParallel = 1e-12;

/// From within reach: does the way lead nearer to the nearest point?
double way_out(const Vec2& by, const Vec2& from_nearest) {
  return by.dot(from_nearest) < -kParallel * by.norm() * from_nearest.norm() ? 0 : kFreeWay;
}

Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return a + t * along;
}

/// The two straight sides of the segment's margin: lines at distance `reach` over the segment itself.
double way_to_side(const Vec2& from, const Vec2& by, double reach, const Vec2& a, const Vec2& along) {
  const double length = along.norm();
  const double height = cross(along, from - a) / length;
  const double climb = cross(along, by) / length;
  if (height * climb >= 0 || std::abs(climb) <= kParallel * by.norm()) return kFreeWay;
  // Rounding may put a body that stands at the margin a little inside: it may not go on, either.
  const double share = std::max(0.0, (std::abs(height) - reach) / std::abs(climb));
  const double foot = (from + share * by - a).dot(along);
  return share <= 1 && foot >= 0 && foot <= length * length ? share : kFreeWay;
}

}  // namespace

double way_to_point(const Vec2& from, const Vec2& by, double reach, const Vec2& point) {
  const Vec2 f = from - point;
  const double c = f.squaredNorm() - reach * reach;
  if (c <= 0) return way_out(by, f);
  // |f + t by|^2 = reach^2, the smaller root.
  const double a = by.squaredNorm();
  const double b = by.dot(f);
  const double d = b * b - a * c;
  if (b >= 0 || d < 0) return kFreeWay;
  const double share = c / (std::sqrt(d) - b);
  return share <= 1 ? share : kFreeWay;
}

double way_to_segment(const Vec2& from, const Vec2& by, double reach, const Vec2& a, const Vec2& b) {
  const Vec2 f = from - nearest_on_segment(from, a, b);
  const double distance = f.norm();
  if (distance <= reach) return way_out(by, f);
  if (distance - by.norm() > reach) return kFreeWay;
  return std::min(
      {way_to_point(from, by, reach, a), way_to_point(from, by, reach, b), way_to_side(from, by, reach, a, b - a)});
}

double Surroundings::way(const Vec2& from, const Vec2& by, double radius) const {
  const double reach = radius + kContactSkin;
  double share = kFreeWay;
  for (const Wall& wall : walls_) share = std::min(share, way_to_segment(from, by, reach, wall.a, wall.b));
  for (const Pole& pole : poles_)
    share = std::min(share, way_to_point(from, by, reach + pole.disc.radius, pole.disc.center));
  return share;
}

}  // namespace meander
