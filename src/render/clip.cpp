// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/clip.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace meander {
namespace {

bool inside(const std::vector<Vec2>& points, const Box& box) {
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) { return box.contains(p); });
}

/// The side of `ring` where sign * (p[axis] - limit) <= 0.
std::vector<Vec2> half(const std::vector<Vec2>& ring, int axis, double limit, double sign) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    const double da = sign * (a[axis] - limit);
    const double db = sign * (b[axis] - limit);
    if (da <= 0) kept.push_back(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

/// The part [from, to] of the segment a-b inside the box, as shares of its length.
std::optional<std::pair<double, double>> inside_part(const Vec2& a, const Vec2& b, const Box& box) {
  double from = 0, to = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    double enter = box.low[axis] - a[axis];
    double leave = box.high[axis] - a[axis];
    if (way == 0) {
      if (enter > 0 || leave < 0) return std::nullopt;
      continue;
    }
    enter /= way, leave /= way;
    if (enter > leave) std::swap(enter, leave);
    from = std::max(from, enter);
    to = std::min(to, leave);
  }
  if (from > to) return std::nullopt;
  return std::pair{from, to};
}

}  // namespace

std::vector<Vec2> clipped_ring(std::vector<Vec2> ring, const Box& box) {
  if (inside(ring, box)) return ring;
  for (int axis = 0; axis < 2; ++axis) {
    ring = half(ring, axis, box.low[axis], -1);
    ring = half(ring, axis, box.high[axis], 1);
  }
  return ring;
}

std::vector<Ring> clipped_line(const std::vector<Vec2>& points, bool closed, const Box& box) {
  if (inside(points, box)) return {Ring{points, closed}};
  std::vector<Ring> parts;
  bool joined = false;  // does the last part end where the next segment begins?
  const std::size_t segments = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < segments; ++i) {
    const Vec2& a = points[i];
    const Vec2& b = points[(i + 1) % points.size()];
    const auto part = inside_part(a, b, box);
    if (!part) {
      joined = false;
      continue;
    }
    if (!joined) parts.push_back({{part->first > 0 ? Vec2(a + (b - a) * part->first) : a}, false});
    parts.back().points.push_back(part->second < 1 ? Vec2(a + (b - a) * part->second) : b);
    joined = part->second == 1;
  }
  return parts;
}

std::vector<Vec2> circle(const Disc& disc, double radius_units) {
  // Sagitta r (1 - cos(pi / n)) <= 0.1, that is n >= pi sqrt(5 r).
  const double wanted = kPi * std::sqrt(5 * std::clamp(radius_units, 1.0, 20'000.0));
  const int count = static_cast<int>(std::ceil(wanted / 4)) * 4;
  std::vector<Vec2> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const SinCos t = sin_cos(2 * kPi * i / count);
    points.push_back(disc.center + disc.radius * Vec2(t.cos, t.sin));
  }
  return points;
}

}  // namespace meander
