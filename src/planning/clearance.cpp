// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/clearance.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

double point_to_square(const Vec2& p, double x, double y) {
  const double dx = std::max({x - p.x(), p.x() - x - 1, 0.0}), dy = std::max({y - p.y(), p.y() - y - 1, 0.0});
  return std::sqrt(dx * dx + dy * dy);
}

double point_to_piece(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((p - from).dot(way) / length, 0.0, 1.0) : 0.0;
  return (from + share * way - p).norm();
}

/// Has the piece a point inside of the square, and not just by rounding? By the part of it that lies between its sides
/// (Liang and Barsky).
bool meets_square(const Vec2& from, const Vec2& to, double x, double y) {
  constexpr double kRounding = 1e-9;
  double begin = 0, end = 1;
  const Vec2 way = to - from, corner(x, y);
  for (int k = 0; k < 2; ++k) {
    const double low = corner[k] + kRounding, high = corner[k] + 1 - kRounding;
    if (way[k] == 0) {
      if (from[k] <= low || from[k] >= high) return false;
      continue;
    }
    const double a = (low - from[k]) / way[k], b = (high - from[k]) / way[k];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin < end;
}

}  // namespace

double distance_to_square(const Vec2& from, const Vec2& to, double x, double y) {
  if (meets_square(from, to, x, y)) return -1;
  double least = std::min(point_to_square(from, x, y), point_to_square(to, x, y));
  for (const Vec2& corner : {Vec2(x, y), Vec2(x + 1, y), Vec2(x, y + 1), Vec2(x + 1, y + 1)})
    least = std::min(least, point_to_piece(corner, from, to));
  return least;
}

Clearance::Clearance(const Grid<std::uint8_t>& solid, const Work& work)
    : width_(solid.width()), height_(solid.height()), left_(width_, height_), right_(width_, height_) {
  for (int y = 0; y < height_; ++y) {
    work.poll();
    for (int x = 0, last = -1; x < width_; ++x) {
      if (solid[{x, y}] != 0) last = x;
      left_[{x, y}] = last;
    }
    for (int x = width_ - 1, last = width_; x >= 0; --x) {
      if (solid[{x, y}] != 0) last = x;
      right_[{x, y}] = last;
    }
  }
}

double Clearance::of_row(const Vec2& from, const Vec2& to, int row, double least) const {
  if (row < 0 || row >= height_) {  // the rim goes on for ever
    const double beyond = row < 0 ? std::min(from.y(), to.y()) : height_ - std::max(from.y(), to.y());
    return std::min(least, beyond);
  }
  const int first = std::clamp(static_cast<int>(std::floor(std::min(from.x(), to.x()))), 0, width_ - 1);
  const int last = std::clamp(static_cast<int>(std::floor(std::max(from.x(), to.x()))), 0, width_ - 1);
  least = std::min(least, distance_to_square(from, to, left_[{first, row}], row));
  for (int x = right_[{first, row}]; x < width_; x = x + 1 < width_ ? right_[{x + 1, row}] : width_) {
    least = std::min(least, distance_to_square(from, to, x, row));
    if (x >= last) break;
  }
  if (right_[{last, row}] == width_) least = std::min(least, distance_to_square(from, to, width_, row));
  return least;
}

double Clearance::of_short_piece(const Vec2& from, const Vec2& to, double enough) const {
  const int low = static_cast<int>(std::floor(std::min(from.y(), to.y())));
  const int high = static_cast<int>(std::floor(std::max(from.y(), to.y())));
  double least = std::numeric_limits<double>::infinity();
  for (int row = low; row <= high; ++row) least = of_row(from, to, row, least);
  // Rows further and further away, until none of their cells can be nearer.
  for (int away = 1; away - 1 < std::min(least, enough) && (low - away >= -1 || high + away <= height_); ++away) {
    least = of_row(from, to, std::max(low - away, -1), least);
    least = of_row(from, to, std::min(high + away, height_), least);
  }
  return least;
}

double Clearance::of(const Vec2& from, const Vec2& to, double enough) const {
  const Vec2 high(width_, height_);
  if (((from.array() < 0) || (to.array() < 0) || (from.array() > high.array()) || (to.array() > high.array())).any())
    return -1;
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).cwiseAbs().maxCoeff())));
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < pieces; ++i) {
    const Vec2 a = from + (to - from) * (static_cast<double>(i) / pieces);
    const Vec2 b = i + 1 == pieces ? to : Vec2(from + (to - from) * ((i + 1.0) / pieces));
    least = std::min(least, of_short_piece(a, b, std::min(least, enough)));
  }
  return least;
}

}  // namespace meander
