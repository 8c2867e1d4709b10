// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_pieces.hpp"

#include <array>
#include <span>

namespace meander {
namespace {

/// A turn of less than this counts as straight on [rad]: such a vertex is no corner.
constexpr double kStraight = 1e-6;

bool turns_left(const Vec2& before, const Vec2& at, const Vec2& after) {
  const Vec2 in = at - before, out = after - at;
  const double turn = cross(in, out);
  return turn > 0 && turn * turn > kStraight * kStraight * in.squaredNorm() * out.squaredNorm();
}

bool bends(const Vec2& before, const Vec2& at, const Vec2& after) {
  return (at - before).dot(after - at) < 0 || turns_left(before, at, after) || turns_left(after, at, before);
}

void append_run(std::span<const Vec2> p, bool closed, std::vector<Wall>& walls) {
  const std::size_t edges = closed ? p.size() : p.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    Wall& wall = walls.emplace_back(Wall{.a = p[i], .b = p[(i + 1) % p.size()], .solid = false});
    const bool free_end = !closed && i == 0;
    wall.convex_a = free_end || bends(p[(i + p.size() - 1) % p.size()], wall.a, wall.b);
    wall.convex_b = !closed && i + 1 == edges;
  }
}

/// The ring's walls from its first point on, counter-clockwise or clockwise, whichever way its points run.
void append_ring(std::span<const Vec2> p, bool counter_clockwise, std::vector<Wall>& walls) {
  double doubled_area = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) doubled_area += cross(p[i] - p[0], p[i + 1] - p[0]);
  const bool reversed = (doubled_area > 0) != counter_clockwise;
  const std::size_t n = p.size();
  const auto at = [&](std::size_t i) -> const Vec2& { return p[(reversed ? 2 * n - i : i) % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    Wall& wall = walls.emplace_back(Wall{.a = at(i), .b = at(i + 1)});
    wall.convex_a = turns_left(at(i + n - 1), wall.a, wall.b);
  }
}

struct WallAppender {
  std::vector<Wall>& walls;

  void operator()(const Chain& chain) const { append_run(chain.points, chain.closed, walls); }
  void operator()(const Polygon& polygon) const {
    append_ring(polygon.outer, true, walls);
    for (const auto& hole : polygon.holes) append_ring(hole, false, walls);
  }
  void operator()(const Rectangle& rectangle) const { append_ring(corners(rectangle), true, walls); }
  void operator()(const Disc&) const {}
};

}  // namespace

void append_walls(const Shape& shape, std::vector<Wall>& walls) { std::visit(WallAppender{walls}, shape); }

}  // namespace meander
