// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shapes.hpp"

#include <algorithm>
#include <limits>

#include "geometry/segment.hpp"

namespace meander {
namespace {

template <class... Case>
struct Overload : Case... {
  using Case::operator()...;
};
template <class... Case>
Overload(Case...) -> Overload<Case...>;  // clang 14 does not deduce it by itself

double doubled_area(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return sum;
}

void orient(std::vector<Vec2>& ring, bool counter_clockwise) {
  if (!ring.empty() && (doubled_area(ring) > 0) != counter_clockwise) std::reverse(ring.begin() + 1, ring.end());
}

/// Calls visit(a, b) for every edge of the ring.
template <class Visit>
void for_each_edge(const Ring& ring, Visit visit) {
  for (std::size_t i = 1; i < ring.points.size(); ++i) visit(ring.points[i - 1], ring.points[i]);
  if (ring.closed && !ring.points.empty()) visit(ring.points.back(), ring.points.front());
}

double distance_to_border(const std::vector<Ring>& border, const Vec2& point) {
  double best = std::numeric_limits<double>::infinity();
  for (const Ring& ring : border)
    for_each_edge(
        ring, [&](const Vec2& a, const Vec2& b) { best = std::min(best, squared_distance_to_segment(point, a, b)); });
  return std::sqrt(best);
}

bool encloses(const std::vector<Ring>& border, const Vec2& point) {
  int crossings = 0;
  for (const Ring& ring : border)
    for_each_edge(ring, [&](const Vec2& a, const Vec2& b) { crossings += winding_step(point, a, b) != 0; });
  return crossings % 2 != 0;
}

}  // namespace

Shape canonical(Shape shape) {
  if (auto* polygon = std::get_if<Polygon>(&shape)) {
    orient(polygon->outer, true);
    for (auto& hole : polygon->holes) orient(hole, false);
  }
  return shape;
}

std::array<Vec2, 4> corners(const Rectangle& r) {
  const SinCos turn = sin_cos(r.heading);
  const Vec2 u = 0.5 * r.size.x() * Vec2(turn.cos, turn.sin), v = 0.5 * r.size.y() * Vec2(-turn.sin, turn.cos);
  return {r.center - u - v, r.center + u - v, r.center + u + v, r.center - u + v};
}

std::vector<Ring> rings(const Shape& shape) {
  return std::visit(Overload{
                        [](const Chain& c) {
                          return std::vector<Ring>{{c.points, c.closed}};
                        },
                        [](const Polygon& p) {
                          std::vector<Ring> all{{p.outer, true}};
                          for (const auto& hole : p.holes) all.push_back({hole, true});
                          return all;
                        },
                        [](const Rectangle& r) {
                          const std::array<Vec2, 4> c = corners(r);
                          return std::vector<Ring>{{{c.begin(), c.end()}, true}};
                        },
                        [](const Disc&) { return std::vector<Ring>{}; },
                    },
                    shape);
}

Box bounding_box(const Shape& shape) {
  if (const auto* disc = std::get_if<Disc>(&shape)) {
    const Vec2 r(disc->radius, disc->radius);
    return {disc->center - r, disc->center + r};
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Ring& ring : rings(shape))
    for (const Vec2& p : ring.points) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
  return box;
}

Vec2 center(const Shape& shape) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return disc->center;
  if (const auto* rectangle = std::get_if<Rectangle>(&shape)) return rectangle->center;
  return bounding_box(shape).center();
}

bool contains(const Shape& shape, const Vec2& point) {
  if (std::holds_alternative<Chain>(shape)) return false;
  if (const auto* disc = std::get_if<Disc>(&shape)) return (point - disc->center).norm() <= disc->radius + kTouch;
  const std::vector<Ring> border = rings(shape);
  return encloses(border, point) || distance_to_border(border, point) <= kTouch;
}

double distance(const Shape& shape, const Vec2& point) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return std::max(0.0, (point - disc->center).norm() - disc->radius);
  const std::vector<Ring> border = rings(shape);
  if (!std::holds_alternative<Chain>(shape) && encloses(border, point)) return 0;
  return distance_to_border(border, point);
}

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  return std::sqrt(squared_distance_to_segment(point, a, b));
}

}  // namespace meander
