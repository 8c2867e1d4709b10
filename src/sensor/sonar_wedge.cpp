// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_wedge.hpp"

#include <algorithm>
#include <optional>

namespace meander::sonar {
namespace {

/// Room for so many pieces from the first use on, so that scans soon cease to allocate.
constexpr std::size_t kUsual = 64;

/// One end of the part of a wall within the wedge: its place a + t (b - a), and its direction where a border cut it.
struct Cut {
  double t;
  double s = kUnknown;
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
};

struct Part {
  Cut from{0}, to{1};
  /// Keeps what lies on the side where a function that is linear along the wall, and `a` and `b` at its ends, is not
  /// negative.
  bool cut(double a, double b, double s) {
    if (a < 0 && b < 0) return false;
    if (a < 0 && a / (a - b) > from.t) from = {a / (a - b), s};
    if (b < 0 && a / (a - b) < to.t) to = {a / (a - b), s};
    return from.t <= to.t;
  }
};

std::optional<Part> part_in(const Wedge& wedge, const Vec2& a, const Vec2& b) {
  Part part;
  if (!part.cut(a.y() - wedge.low * a.x(), b.y() - wedge.low * b.x(), wedge.low)) return std::nullopt;
  if (!part.cut(wedge.high * a.x() - a.y(), wedge.high * b.x() - b.y(), wedge.high)) return std::nullopt;
  if (wedge.normal.x() == 0 && wedge.normal.y() == 0) return part;
  if (!part.cut(wedge.normal.dot(a) - wedge.offset, wedge.normal.dot(b) - wedge.offset, Cut::kUnknown))
    return std::nullopt;
  return part;
}

/// A wall in local coordinates. Its ends are met exactly, so that walls that share a vertex share its direction.
struct Line {
  Vec2 a, b, d;
  Line(const Vec2& from, const Vec2& to) : a(from), b(to), d(to - from) {}
  Vec2 at(double t) const { return t == 1 ? b : Vec2(a + t * d); }
};

struct Spot {
  double s, w;
};

Spot spot(const Line& line, const Cut& cut, const Wedge& wedge) {
  const Vec2 p = line.at(cut.t);
  const double w = 1 / p.x();
  return {std::isnan(cut.s) ? std::clamp(p.y() * w, wedge.low, wedge.high) : cut.s, w};
}

double square(double x) { return x * x; }

/// Directions within angle asin(sine) of `toward` (unit) that lie in the wedge.
struct Sector {
  double low, high;
};
std::optional<Sector> sector_in(const Wedge& wedge, const Vec2& toward, double sine) {
  const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
  const Vec2 right = cosine * toward - sine * left_of(toward), left = cosine * toward + sine * left_of(toward);
  const auto in_wedge = [&](const Vec2& v) {
    return v.x() > 0 && v.y() >= wedge.low * v.x() && v.y() <= wedge.high * v.x();
  };
  const auto in_sector = [&](double s) { return cross(right, Vec2(1, s)) >= 0 && cross(Vec2(1, s), left) >= 0; };
  Sector sector;
  if (in_wedge(right))
    sector.low = right.y() / right.x();
  else if (in_sector(wedge.low))
    sector.low = wedge.low;
  else
    return std::nullopt;
  if (in_wedge(left))
    sector.high = left.y() / left.x();
  else if (in_sector(wedge.high))
    sector.high = wedge.high;
  else
    return std::nullopt;
  if (sector.low > sector.high) return std::nullopt;
  return sector;
}

/// The direction of the sector that is nearest to that of the disc's centre.
double nearest_direction(const Sector& sector, const Vec2& center) {
  if (cross(Vec2(1, sector.low), center) <= 0) return sector.low;
  if (cross(Vec2(1, sector.high), center) >= 0) return sector.high;
  return center.y() / center.x();
}

/// Sine of the angle from the centre, at distance d, within which a disc's front is nearer than `range`; negative:
/// none.
double sine_within(double range, double d, double radius) {
  if (range < d - radius) return -1;
  const double tangent_squared = (d - radius) * (d + radius);
  if (range * range >= tangent_squared) return radius / d;
  const double cosine = (tangent_squared + range * range) / (2 * d * range);
  return std::sqrt(std::max(0.0, 1 - cosine * cosine));
}

/// Half the length of the part of a wall that answers, around the foot of the perpendicular and as a share of the wall;
/// negative: none. `area` = |a x b| of its ends, so that the wall's line is area / length away.
double answering_half(double area, double length_squared, const Reflector& reflector, const Hearing& hearing) {
  const auto half_within = [&](double range) {
    const double left = square(range) * length_squared - square(area);
    return left < 0 ? -1 : std::sqrt(left) / length_squared;
  };
  double half = kNever;
  if (hearing.incidence) {
    half = area * reflector.tan_limit / length_squared;
    if (hearing.near_field > 0) half = std::max(half, half_within(hearing.near_field));
  }
  const double strength = reflector.strength * hearing.strength;
  if (strength < 1) half = strength > 0 ? std::min(half, half_within(strength * hearing.range)) : -1;
  return half;
}

/// The same for a disc: sine of the angle from its centre within which its front answers.
double answering_sine(double d, double radius, const Reflector& reflector, const Hearing& hearing) {
  double sine = radius / d;
  if (hearing.incidence) sine = std::max(sine * reflector.sin_limit, sine_within(hearing.near_field, d, radius));
  const double strength = reflector.strength * hearing.strength;
  if (strength < 1) sine = strength > 0 ? std::min(sine, sine_within(strength * hearing.range, d, radius)) : -1;
  return sine;
}

/// Of a disc that reaches through the screen: does it stand beyond it in this wedge? The wedge looks through free
/// places of the screen, so that the disc is beyond it in all directions or in none.
bool beyond_screen(const Piece& disc, const Wedge& wedge) {
  const double s = 0.5 * (disc.low + disc.high), range = front_of(disc, s), x = range / std::sqrt(1 + s * s);
  return wedge.normal.x() * x + wedge.normal.y() * x * s >= wedge.offset;
}

}  // namespace

double front_of(const Piece& disc, double s) {
  const double h = std::sqrt(1 + s * s);
  const double along = (disc.center.x() + s * disc.center.y()) / h, aside = (disc.center.y() - s * disc.center.x()) / h;
  return along - std::sqrt(std::max(0.0, square(disc.radius) - square(aside)));
}

void WedgeView::start(const View& from, const Wedge& in, const Hearing& how, std::span<const Reflector> of) {
  view = from, wedge = in, hearing = how, reflectors = of;
  pieces.clear();
  echoes.clear();
  pieces.reserve(kUsual);
  echoes.reserve(kUsual);
}

void WedgeView::add(const Wall& wall, std::uint32_t source, double most) {
  const Line line(view.local(wall.a), view.local(wall.b));
  const std::optional<Part> part = part_in(wedge, line.a, line.b);
  if (!part) return;
  const double length_squared = line.d.squaredNorm();
  const double foot = length_squared > 0 ? -line.a.dot(line.d) / length_squared : 0;
  const double nearest = std::clamp(foot, part->from.t, part->to.t);
  const double near = line.at(nearest).norm();
  if (!(near < most)) return;
  const Reflector& reflector = reflectors[wall.material];
  if (wall.convex_a && part->from.t == 0) add_corner(line.a, reflector, most);
  if (wall.convex_b && part->to.t == 1) add_corner(line.b, reflector, most);
  if (length_squared == 0) return;

  const Spot from = spot(line, part->from, wedge), to = spot(line, part->to, wedge);
  const bool turned = from.s > to.s;
  const Spot &low = turned ? to : from, &high = turned ? from : to;
  pieces.push_back({.low = low.s, .high = high.s, .w_low = low.w, .w_high = high.w, .near = near, .source = source});

  const double half = answering_half(std::abs(cross(line.a, line.d)), length_squared, reflector, hearing);
  const double first = std::max(part->from.t, foot - half), last = std::min(part->to.t, foot + half);
  if (!(first <= last)) return;
  const double best = std::clamp(foot, first, last);
  const double range = best == nearest ? near : line.at(best).norm();
  if (!(range < most)) return;
  const Spot first_spot = first == part->from.t ? from : spot(line, {first}, wedge);
  const Spot last_spot = last == part->to.t ? to : spot(line, {last}, wedge);
  const Spot best_spot = best == first ? first_spot : best == last ? last_spot : spot(line, {best}, wedge);
  echoes.push_back({.range = range,
                    .s = best_spot.s,
                    .w = best_spot.w,
                    .low = std::min(first_spot.s, last_spot.s),
                    .high = std::max(first_spot.s, last_spot.s),
                    .piece = static_cast<std::uint32_t>(pieces.size() - 1)});
}

void WedgeView::add_corner(const Vec2& p, const Reflector& reflector, double most) {
  const double range = p.norm();
  if (!(range < most) || range > hearing.corner_range * reflector.strength * hearing.strength ||
      reflector.strength == 0)
    return;
  const double s = std::clamp(p.y() * (1 / p.x()), wedge.low, wedge.high);
  echoes.push_back({.range = range, .s = s, .w = 1 / p.x(), .low = s, .high = s, .piece = Echo::kCorner});
}

void WedgeView::add(const Pole& pole, std::uint32_t source, double most) {
  const Vec2 center = view.local(pole.disc.center);
  const double radius = pole.disc.radius, d = center.norm();
  const double depth = wedge.normal.dot(center) - wedge.offset;
  if (d <= radius + kTouch || !(d - radius < most) || depth <= -radius) return;
  const Vec2 toward = center / d;
  const std::optional<Sector> seen = sector_in(wedge, toward, radius / d);
  if (!seen) return;

  Piece piece{.low = seen->low,
              .high = seen->high,
              .w_low = 0,
              .w_high = 0,
              .near = 0,
              .center = center,
              .radius = radius,
              .source = source};
  const double chord = (d - radius) * (d + radius);  // the chord is center . P = chord, the polar line of the origin
  piece.w_low = (center.x() + seen->low * center.y()) / chord;
  piece.w_high = (center.x() + seen->high * center.y()) / chord;
  piece.near = front_of(piece, nearest_direction(*seen, center));
  if (!(piece.near < most)) return;
  if (depth < radius && !beyond_screen(piece, wedge)) return;
  pieces.push_back(piece);

  const double sine = answering_sine(d, radius, reflectors[pole.material], hearing);
  if (sine < 0) return;
  const std::optional<Sector> heard = sector_in(wedge, toward, sine);
  if (!heard) return;
  const double s = nearest_direction(*heard, center), range = front_of(piece, s);
  if (!(range < most)) return;
  echoes.push_back({.range = range,
                    .s = s,
                    .w = std::sqrt(1 + s * s) / range,
                    .low = heard->low,
                    .high = heard->high,
                    .piece = static_cast<std::uint32_t>(pieces.size() - 1)});
}

}  // namespace meander::sonar
