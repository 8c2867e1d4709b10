// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_occlusion.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace meander::sonar {
namespace {

/// Nearer by less than this share counts as touching: a wall does not hide its own end or a coincident wall.
constexpr double kTouching = 1e-10;
constexpr double kNearer = 1 + kTouching;
/// By which a shadow is widened on either side, in s.
constexpr double kSlack = 1e-10;

Vec2 point_at(double s, double w) { return {1 / w, s / w}; }

double range_of(const Piece& piece, double s) { return piece.disc() ? front_of(piece, s) : distance_at(s, piece.w(s)); }

struct Roots {
  double first, last;
  bool real;
};

/// Where a + t d meets the disc's rim.
Roots rim_crossings(const Vec2& a, const Vec2& d, const Piece& disc) {
  const Vec2 e = a - disc.center;
  const double dd = d.squaredNorm(), ed = e.dot(d),
               inside = ed * ed - dd * (e.squaredNorm() - disc.radius * disc.radius);
  if (!(inside > 0) || dd == 0) return {0, 0, false};
  const double root = std::sqrt(inside);
  return {(-ed - root) / dd, (-ed + root) / dd, true};
}

/// Directions in which two rims cross.
void add_rim_crossings(const Piece& a, const Piece& b, std::vector<double>& breaks) {
  const Vec2 d = b.center - a.center;
  const double dd = d.squaredNorm();
  if (dd == 0) return;
  const double along = (dd + a.radius * a.radius - b.radius * b.radius) / (2 * dd);
  const double aside_squared = a.radius * a.radius / dd - along * along;
  if (!(aside_squared > 0)) return;
  const double aside = std::sqrt(aside_squared);
  for (const double side : {-aside, aside}) {
    const Vec2 p = a.center + along * d + side * left_of(d);
    if (p.x() > 0) breaks.push_back(p.y() / p.x());
  }
}

}  // namespace

bool hides(const Piece& piece, double s, double w) {
  if (s < piece.low || s > piece.high) return false;
  if (piece.w(s) > w * kNearer) return true;
  return piece.disc() && (point_at(s, w) - piece.center).squaredNorm() * kNearer < piece.radius * piece.radius;
}

void Shadows::add(double low, double high) { intervals_.push_back({low - kSlack, high + kSlack}); }

/// Where the straight line of `other` (a wall, or a disc's chord) is nearer than that of the target.
void Shadows::add_below(const Piece& target, const Piece& other) {
  double low = std::max(target.low, other.low), high = std::min(target.high, other.high);
  if (!(low < high)) return;
  const double at_low = other.w(low) - target.w(low), at_high = other.w(high) - target.w(high);
  const double touch = kTouching * std::max(target.w_low, target.w_high);
  if (at_low <= touch && at_high <= touch) return;
  // Lines that touch at an end do so exactly: there the shadow is closed.
  const double crossing = low + (high - low) * (at_low / (at_low - at_high));
  if (at_low < -touch) low = crossing;
  if (at_high < -touch) high = crossing;
  add(low, high);
}

/// Where a wall runs inside a disc: in front of its chord, but behind its rim.
void Shadows::add_within(const Piece& wall, const Piece& disc) {
  const Vec2 a = point_at(wall.low, wall.w_low), d = point_at(wall.high, wall.w_high) - a;
  const Roots t = rim_crossings(a, d, disc);
  if (!t.real || t.last <= 0 || t.first >= 1) return;
  const Vec2 from = a + std::max(0.0, t.first) * d, to = a + std::min(1.0, t.last) * d;
  add(from.y() / from.x(), to.y() / to.x());
}

/// Where another piece stands in front of a disc: between the directions in which the outlines cross it is so
/// throughout or nowhere.
void Shadows::add_before_disc(const Piece& disc, const Piece& other) {
  const double low = std::max(disc.low, other.low), high = std::min(disc.high, other.high);
  if (!(low < high)) return;
  breaks_.assign({low, high});
  if (other.disc()) {
    add_rim_crossings(disc, other, breaks_);
  } else {
    const Vec2 a = point_at(other.low, other.w_low), d = point_at(other.high, other.w_high) - a;
    if (const Roots t = rim_crossings(a, d, disc); t.real)
      for (const double at : {t.first, t.last})
        if (const Vec2 p = a + at * d; p.x() > 0) breaks_.push_back(p.y() / p.x());
  }
  std::sort(breaks_.begin(), breaks_.end());
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
    const double from = std::max(low, breaks_[i]), to = std::min(high, breaks_[i + 1]), middle = 0.5 * (from + to);
    if (from < to && range_of(other, middle) * kNearer < range_of(disc, middle)) add(from, to);
  }
}

void Shadows::cast(const Piece& target, std::span<const Piece> pieces, double most) {
  intervals_.clear();
  for (const Piece& other : pieces) {
    if (other.near > most || &other == &target) continue;
    if (target.disc()) {
      add_before_disc(target, other);
    } else {
      add_below(target, other);
      if (other.disc()) add_within(target, other);
    }
  }
  merge();
}

void Shadows::merge() {
  if (intervals_.empty()) return;
  std::sort(intervals_.begin(), intervals_.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < intervals_.size(); ++i) {
    if (intervals_[i].low <= intervals_[last].high)
      intervals_[last].high = std::max(intervals_[last].high, intervals_[i].high);
    else
      intervals_[++last] = intervals_[i];
  }
  intervals_.resize(last + 1);
}

namespace {

bool hidden_corner(const Echo& corner, std::span<const Piece> pieces) {
  const double w = 1 / corner.at.x(), s = corner.at.y() * w;
  return std::any_of(pieces.begin(), pieces.end(),
                     [&](const Piece& piece) { return piece.near <= corner.range && hides(piece, s, w); });
}

/// Is the direction of the point p (X > 0) lower than s?
bool lower(const Vec2& p, double s) { return p.y() < s * p.x(); }

/// Of the two ends of the shadow over the echo, the nearer one that still answers; false where no shadow lies. Ranges
/// grow away from the echo's place.
bool leave_shadow(Echo& echo, const Piece& piece, std::span<const Interval> shadows) {
  const auto over = std::find_if(shadows.begin(), shadows.end(), [&](const Interval& i) {
    return !lower(echo.at, i.low) && lower(echo.at, i.high) && echo.at.y() != i.low * echo.at.x();
  });
  if (over == shadows.end()) return false;
  const double left = lower(echo.low, over->low) ? range_of(piece, over->low) : kNever;
  const double right = lower(echo.high, over->high) ? kNever : range_of(piece, over->high);
  echo.at = {1, left <= right ? over->low : over->high};
  echo.range = std::max(echo.range, std::min(left, right));
  return true;
}

}  // namespace

void settle(Echo& echo, std::span<const Piece> pieces, double reach, Shadows& shadows) {
  if (echo.piece == Echo::kCorner) {
    if (hidden_corner(echo, pieces)) echo.range = kNever;
    return;
  }
  // Farther pieces hide nothing that is nearer; as the echo moves away, more pieces count.
  const Piece& piece = pieces[echo.piece];
  do {
    shadows.cast(piece, pieces, echo.range);
  } while (leave_shadow(echo, piece, shadows.intervals()) && echo.range < reach);
}

}  // namespace meander::sonar
