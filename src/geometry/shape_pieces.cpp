// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// A turn of less than this counts as straight on [rad]; such a vertex is no corner.
constexpr double kStraight = 1e-6;

bool turns_left(const Vec2& before, const Vec2& at, const Vec2& after) {
  const Vec2 in = at - before, out = after - at;
  return cross(in, out) > kStraight * in.norm() * out.norm();
}

bool bends(const Vec2& before, const Vec2& at, const Vec2& after) {
  return (at - before).dot(after - at) < 0 || turns_left(before, at, after) || turns_left(after, at, before);
}

void add_walls(const Ring& ring, bool solid, std::vector<Wall>& walls) {
  const auto& p = ring.points;
  const std::size_t count = p.size(), edges = ring.closed ? count : count - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    Wall wall{.a = p[i], .b = p[(i + 1) % count], .solid = solid};
    const bool inner = ring.closed || i > 0;
    const Vec2& before = p[(i + count - 1) % count];
    wall.convex_a = !inner || (solid ? turns_left(before, wall.a, wall.b) : bends(before, wall.a, wall.b));
    wall.convex_b = !ring.closed && i + 1 == edges;
    walls.push_back(wall);
  }
}

}  // namespace

ShapePieces pieces_of(const Shape& shape) {
  ShapePieces pieces{.walls = {}, .pole = {}, .box = bounding_box(shape)};
  const bool solid = !std::holds_alternative<Chain>(shape);
  for (const Ring& ring : rings(canonical(shape))) add_walls(ring, solid, pieces.walls);
  if (const auto* disc = std::get_if<Disc>(&shape)) pieces.pole = Pole{.disc = *disc};
  return pieces;
}

void NearestHit::take(double range, double cosine, std::uint32_t owner) {
  if (range > range_ || (found_ && range == range_ && owner >= owner_)) return;
  range_ = range, cosine_ = cosine, owner_ = owner, found_ = true;
}

void NearestHit::meet(const Wall& wall) {
  const Vec2 a = wall.a - origin_, b = wall.b - origin_;
  const double side_a = cross(direction_, a), side_b = cross(direction_, b);
  if (side_a * side_b > 0) return;
  const double along_a = direction_.dot(a), along_b = direction_.dot(b);
  double range = std::min(along_a, along_b);  // of a wall seen end on: its nearer end
  if (side_a != side_b)
    range = (along_a * side_b - along_b * side_a) / (side_b - side_a);
  else if (std::max(along_a, along_b) >= 0)
    range = std::max(range, 0.0);
  if (range >= 0) take(range, std::abs(side_b - side_a) / (wall.b - wall.a).norm(), wall.owner);
}

void NearestHit::meet(const Pole& pole) {
  const Vec2 c = pole.disc.center - origin_;
  const double r = pole.disc.radius, aside = cross(direction_, c), along = direction_.dot(c);
  if (std::abs(aside) > r) return;
  const double half_chord = std::sqrt(r * r - aside * aside);
  const double range = along - half_chord >= 0 ? along - half_chord : along + half_chord;
  if (range >= 0) take(range, half_chord / r, pole.owner);
}

std::optional<RayHit> NearestHit::hit() const {
  if (!found_) return std::nullopt;
  const double incidence = angle_of(std::sqrt(std::max(0.0, 1 - cosine_ * cosine_)), cosine_);
  return RayHit{range_, origin_ + range_ * direction_, incidence, owner_};
}

}  // namespace meander
