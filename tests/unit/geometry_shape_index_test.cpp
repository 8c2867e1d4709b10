// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_index.hpp"

#include <gtest/gtest.h>

#include <map>

#include "base/random.hpp"
#include "geometry/segment.hpp"

namespace meander {
namespace {

using Shapes = std::map<std::uint32_t, Shape>;

/// All edges of a shape as pairs of points, taken from the public rings.
std::vector<std::pair<Vec2, Vec2>> edges(const Shape& shape) {
  std::vector<std::pair<Vec2, Vec2>> all;
  for (const Ring& ring : rings(shape))
    for (std::size_t i = 0; i + (ring.closed ? 0 : 1) < ring.points.size(); ++i)
      all.emplace_back(ring.points[i], ring.points[(i + 1) % ring.points.size()]);
  return all;
}

/// Range to a segment by Cramer's rule in extended precision; parallel rays meet the nearer end.
double segment_range(const Vec2& o, const Vec2& u, const Vec2& a, const Vec2& b) {
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

double disc_range(const Vec2& o, const Vec2& u, const Disc& disc) {
  const Vec2 c = disc.center - o;
  const double b = c.dot(u), q = b * b - c.squaredNorm() + disc.radius * disc.radius;
  if (q < 0) return std::numeric_limits<double>::infinity();
  for (const double range : {b - std::sqrt(q), b + std::sqrt(q)})
    if (range >= 0) return range;
  return std::numeric_limits<double>::infinity();
}

double brute_range(const Shapes& shapes, const Vec2& o, const Vec2& u, double max_range) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [owner, shape] : shapes) {
    for (const auto& [a, b] : edges(shape)) best = std::min(best, segment_range(o, u, a, b));
    if (const auto* disc = std::get_if<Disc>(&shape)) best = std::min(best, disc_range(o, u, *disc));
  }
  return best <= max_range ? best : std::numeric_limits<double>::infinity();
}

double brute_distance(const Shapes& shapes, const Vec2& p, double most) {
  double best = most;
  for (const auto& [owner, shape] : shapes) {
    for (const auto& [a, b] : edges(shape)) best = std::min(best, distance_to_segment(p, a, b));
    if (const auto* disc = std::get_if<Disc>(&shape))
      best = std::min(best, std::abs((p - disc->center).norm() - disc->radius));
  }
  return best;
}

bool brute_inside(const Shapes& shapes, const Vec2& p) {
  for (const auto& [owner, shape] : shapes)
    if (contains(shape, p)) return true;
  return false;
}

Vec2 random_point(Stream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

Vec2 direction(double angle) {
  const SinCos t = sin_cos(angle);
  return {t.cos, t.sin};
}

std::vector<Vec2> star(Stream& random, int count, double least, double most) {
  std::vector<Vec2> ring;
  for (int i = 0; i < count; ++i)
    ring.push_back(random.uniform(least, most) * direction((i + random.uniform(0.1, 0.9)) * 2 * kPi / count));
  if (random.chance(0.5)) std::reverse(ring.begin(), ring.end());
  return ring;
}

Shape random_shape(Stream& random, double reach, double size) {
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

/// A place where something special happens: on a vertex, an edge, a cell border, or just anywhere.
Vec2 nasty_point(Stream& random, const Shapes& shapes, double reach) {
  const int kind = random.below(5);
  if (kind >= 3 || shapes.empty()) return random_point(random, reach);
  if (kind == 2) return random_point(random, reach).array().round().matrix();
  auto it = shapes.begin();
  std::advance(it, random.below(static_cast<int>(shapes.size())));
  const auto all = edges(it->second);
  if (all.empty()) return std::get<Disc>(it->second).center;
  const auto& [a, b] = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
  return kind == 0 ? a : Vec2(0.5 * (a + b));
}

/// Axis-parallel directions are exact, so that rays run along walls and cell borders.
Vec2 nasty_direction(Stream& random) {
  switch (random.below(6)) {
    case 0:
      return {1, 0};
    case 1:
      return {-1, 0};
    case 2:
      return {0, 1};
    case 3:
      return {0, -1};
    default:
      return direction(random.uniform(-4, 4));
  }
}

void expect_like_brute_force(const ShapeIndex& index, const Shapes& shapes, Stream& random, double reach, int count) {
  for (int i = 0; i < count; ++i) {
    const Vec2 p = nasty_point(random, shapes, reach), u = nasty_direction(random);
    const double most = random.chance(0.5) ? random.uniform(0.1, 8) : 10 * reach;
    const auto hit = index.cast(p, u, most);
    const double expected = brute_range(shapes, p, u, most);
    // A ray that just touches a vertex or the end of its range may go either way by rounding.
    const double found = hit ? hit->range : std::numeric_limits<double>::infinity();
    if (std::abs(found - expected) > 1e-9 || std::isinf(found) != std::isinf(expected)) {
      const auto touch = [&](double r) {
        return std::isinf(r) ? std::abs(brute_distance(shapes, p + std::min(most, 1e3) * u, 1)) < 1e-9
                             : brute_distance(shapes, p + r * u, 1) < 1e-9;
      };
      const Vec2 side = 1e-9 * left_of(u);
      const double left = brute_range(shapes, p + side, u, most + 1e-8),
                   right = brute_range(shapes, p - side, u, most + 1e-8);
      const bool between = (found >= std::min(left, right) - 1e-6 && (found <= std::max(left, right) + 1e-6));
      EXPECT_TRUE(between && touch(std::min(found, expected)))
          << found << " expected " << expected << " at " << p.transpose() << " along " << u.transpose() << " most "
          << most;
    } else if (hit) {
      EXPECT_LE((hit->point - p - hit->range * u).norm(), 1e-9);
    }
    EXPECT_NEAR(index.distance(p, most), brute_distance(shapes, p, most), 1e-9);
    EXPECT_EQ(index.inside(p), brute_inside(shapes, p)) << p.transpose();
  }
}

TEST(ShapeIndex, AnswersLikeBruteForceWhileEdited) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Stream random(seed, "worlds");
    ShapeIndex index(random.chance(0.5) ? 1.0 : 2.0);
    Shapes shapes;
    const double reach = random.uniform(2, 30), size = random.uniform(0.2, 8);
    for (int round = 0; round < 12; ++round) {
      for (int edit = 0; edit < 12; ++edit) {
        const auto owner = static_cast<std::uint32_t>(random.below(40));
        if (shapes.contains(owner)) {
          index.remove(owner);
          shapes.erase(owner);
        } else {
          shapes[owner] = random_shape(random, reach, size);
          index.insert(owner, shapes[owner]);
        }
      }
      expect_like_brute_force(index, shapes, random, 1.5 * reach, 60);
    }
  }
}

}  // namespace
}  // namespace meander
