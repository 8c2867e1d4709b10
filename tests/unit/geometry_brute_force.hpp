// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <limits>
#include <map>

#include "base/random.hpp"
#include "geometry/segment.hpp"
#include "geometry/shapes.hpp"

namespace meander::brute_force {

using Shapes = std::map<std::uint32_t, Shape>;

/// All edges of a shape as pairs of points, taken from the public rings.
inline std::vector<std::pair<Vec2, Vec2>> edges(const Shape& shape) {
  std::vector<std::pair<Vec2, Vec2>> all;
  for (const Ring& ring : rings(shape))
    for (std::size_t i = 0; i + (ring.closed ? 0 : 1) < ring.points.size(); ++i)
      all.emplace_back(ring.points[i], ring.points[(i + 1) % ring.points.size()]);
  return all;
}

/// Range to a segment by Cramer's rule in extended precision; parallel rays meet the nearer end.
inline double segment_range(const Vec2& o, const Vec2& u, const Vec2& a, const Vec2& b) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const long double dx = static_cast<long double>(b.x()) - a.x(), dy = static_cast<long double>(b.y()) - a.y();
  const long double ex = static_cast<long double>(a.x()) - o.x(), ey = static_cast<long double>(a.y()) - o.y();
  const long double across = u.x() * dy - u.y() * dx;
  if (across == 0) {
    if (u.x() * ey - u.y() * ex != 0) return kNone;
    const double s = u.dot(a - o), t = u.dot(b - o);
    if (std::max(s, t) < 0) return kNone;
    return std::max(0.0, std::min(s, t));
  }
  const long double range = (ex * dy - ey * dx) / across, t = (ex * u.y() - ey * u.x()) / across;
  return range >= 0 && t >= 0 && t <= 1 ? static_cast<double>(range) : kNone;
}

inline double disc_range(const Vec2& o, const Vec2& u, const Disc& disc) {
  const Vec2 c = disc.center - o;
  const double b = c.dot(u), q = b * b - c.squaredNorm() + disc.radius * disc.radius;
  if (q < 0) return std::numeric_limits<double>::infinity();
  for (const double range : {b - std::sqrt(q), b + std::sqrt(q)})
    if (range >= 0) return range;
  return std::numeric_limits<double>::infinity();
}

inline double brute_range(const Shapes& shapes, const Vec2& o, const Vec2& u, double max_range) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [owner, shape] : shapes) {
    for (const auto& [a, b] : edges(shape)) best = std::min(best, segment_range(o, u, a, b));
    if (const auto* disc = std::get_if<Disc>(&shape)) best = std::min(best, disc_range(o, u, *disc));
  }
  return best <= max_range ? best : std::numeric_limits<double>::infinity();
}

inline double brute_distance(const Shapes& shapes, const Vec2& p, double most) {
  double best = most;
  for (const auto& [owner, shape] : shapes) {
    for (const auto& [a, b] : edges(shape)) best = std::min(best, distance_to_segment(p, a, b));
    if (const auto* disc = std::get_if<Disc>(&shape))
      best = std::min(best, std::abs((p - disc->center).norm() - disc->radius));
  }
  return best;
}

inline bool brute_inside(const Shapes& shapes, const Vec2& p) {
  for (const auto& [owner, shape] : shapes)
    if (contains(shape, p)) return true;
  return false;
}

inline Vec2 random_point(Stream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

inline Vec2 direction(double angle) {
  const SinCos t = sin_cos(angle);
  return {t.cos, t.sin};
}

inline std::vector<Vec2> star(Stream& random, int count, double least, double most) {
  std::vector<Vec2> ring;
  for (int i = 0; i < count; ++i)
    ring.push_back(random.uniform(least, most) * direction((i + random.uniform(0.1, 0.9)) * 2 * kPi / count));
  if (random.chance(0.5)) std::reverse(ring.begin(), ring.end());
  return ring;
}

inline Shape random_shape(Stream& random, double reach, double size) {
  const Vec2 at = random_point(random, reach);
  switch (random.below(6)) {
    case 0:
      return moved(Chain{star(random, 3 + random.below(8), 0.1 * size, size), random.chance(0.5)}, at);
    case 1:
      return moved(
          Polygon{star(random, 3 + random.below(20), 0.3 * size, size), {star(random, 5, 0.05 * size, 0.1 * size)}},
          at);
    case 2:
      return Disc{at, random.uniform(0.01, 0.5) * size};
    case 3:
      return Rectangle{
          at.array().round().matrix(), {1.0 + random.below(3), 1.0 + random.below(3)}, 0};  // on cell borders
    default:
      return Rectangle{at, {random.uniform(0.05, 1) * size, random.uniform(0.05, 1) * size}, random.uniform(-3, 3)};
  }
}

}  // namespace meander::brute_force
