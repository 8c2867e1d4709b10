// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_wedge.hpp"

#include <algorithm>
#include <optional>

namespace meander::sonar {
namespace {

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
    if (a < 0) {
      if (b < 0) return false;
      const double t = a / (a - b);
      if (t > from.t) from = {t, s};
    } else if (b < 0) {
      const double t = a / (a - b);
      if (t < to.t) to = {t, s};
    }
    return from.t <= to.t;
  }
};

/// A wall in local coordinates.
struct Line {
  Vec2 a, b;
  double length;

  bool cut(const Wedge& wedge, Part& part) const {
    return part.cut(a.y() - wedge.low * a.x(), b.y() - wedge.low * b.x(), wedge.low) &&
           part.cut(wedge.high * a.x() - a.y(), wedge.high * b.x() - b.y(), wedge.high) &&
           (!wedge.screened() ||
            part.cut(wedge.normal.dot(a) - wedge.offset, wedge.normal.dot(b) - wedge.offset, Cut::kUnknown));
  }
  Vec2 at(double place) const { return a + (place / length) * (b - a); }
};

/// An end of a part. Uncut ends are met exactly, so that walls that share a vertex share its direction.
struct End {
  Vec2 at;
  double place;  ///< along the wall [m]
  double s, w;
  End(const Line& line, const Cut& cut, const Wedge& wedge)
      : at(cut.t == 1 ? line.b : Vec2(line.a + cut.t * (line.b - line.a))), place(cut.t * line.length), w(1 / at.x()) {
    s = std::isnan(cut.s) ? std::clamp(at.y() * w, wedge.low, wedge.high) : cut.s;
  }
};

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

/// Half the length [m] of the part of a wall that answers, around the foot of the perpendicular; negative: none.
double answering_half(double depth, const Reflector& reflector, const Hearing& hearing) {
  const auto half_within = [&](double range) { return range < depth ? -1 : std::sqrt(square(range) - square(depth)); };
  double half = kNever;
  if (hearing.incidence) {
    half = depth * reflector.tan_limit;
    if (hearing.near_field > depth) half = std::max(half, half_within(hearing.near_field));
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
}

void WedgeView::add(const Face& face, std::uint32_t source, double most) {
  const Vec2 offset = view.origin - face.a;
  const double side = cross(face.along, offset), depth = std::abs(side);
  if (depth >= most || (face.solid && side >= 0)) return;  // seen from within: the front of its solid hides it
  const Line line{view.local(face.a), view.local(face.b), face.length};
  Part part;
  if (!line.cut(wedge, part)) return;
  const End from(line, part.from, wedge), to(line, part.to, wedge);
  const double foot = face.along.dot(offset);
  const auto distance = [&](double place) {
    if (place <= from.place) return from.at.norm();
    if (place >= to.place) return to.at.norm();
    return place == foot ? depth : std::sqrt(square(depth) + square(place - foot));
  };
  const double near = distance(foot);
  if (!(near < most)) return;
  const bool rising = from.s <= to.s;
  const End &low = rising ? from : to, &high = rising ? to : from;
  pieces.push_back({.low = low.s,
                    .high = high.s,
                    .w_low = low.w,
                    .w_high = high.w,
                    .near = near,
                    .far_squared = std::max(from.at.squaredNorm(), to.at.squaredNorm()),
                    .source = source});

  const double half = answering_half(depth, reflectors[face.kind], hearing);
  const double first = std::max(from.place, foot - half), last = std::min(to.place, foot + half);
  if (!(first <= last)) return;
  const double best = std::clamp(foot, first, last), range = distance(best);
  if (!(range < most)) return;
  const auto point = [&](double place) {
    return place == from.place ? from.at : place == to.place ? to.at : line.at(place);
  };
  const Vec2 start = point(first), stop = point(last);
  echoes.push_back({.range = range,
                    .at = best == first  ? start
                          : best == last ? stop
                                         : point(best),
                    .low = rising ? start : stop,
                    .high = rising ? stop : start,
                    .piece = static_cast<std::uint32_t>(pieces.size() - 1)});
}

void WedgeView::add_corner(const Vec2& corner, std::uint32_t kind, double most) {
  const Vec2 p = view.local(corner);
  if (p.y() < wedge.low * p.x() || p.y() > wedge.high * p.x() || wedge.normal.dot(p) < wedge.offset) return;
  const double strength = reflectors[kind].strength * hearing.strength, range = p.norm();
  if (!(range < most) || range > hearing.corner_range * strength) return;
  echoes.push_back({.range = range, .at = p, .low = p, .high = p, .piece = Echo::kCorner});
}

void WedgeView::add(const Pole& pole, std::uint32_t source, double most) {
  const Vec2 center = view.local(pole.disc.center);
  const double radius = pole.disc.radius, d = center.norm();
  const double depth = wedge.normal.dot(center) - wedge.offset;
  if (d <= radius + kContact || !(d - radius < most) || depth <= -radius) return;
  const Vec2 toward = center / d;
  const std::optional<Sector> seen = sector_in(wedge, toward, radius / d);
  if (!seen) return;

  Piece piece{.low = seen->low,
              .high = seen->high,
              .w_low = 0,
              .w_high = 0,
              .near = 0,
              .far_squared = 0,
              .center = center,
              .radius = radius,
              .source = source};
  const double chord = (d - radius) * (d + radius);  // the chord is center . P = chord, the polar line of the origin
  piece.w_low = (center.x() + seen->low * center.y()) / chord;
  piece.w_high = (center.x() + seen->high * center.y()) / chord;
  piece.far_squared =
      std::max((1 + square(piece.low)) / square(piece.w_low), (1 + square(piece.high)) / square(piece.w_high));
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
                    .at = {1, s},
                    .low = {1, heard->low},
                    .high = {1, heard->high},
                    .piece = static_cast<std::uint32_t>(pieces.size() - 1)});
}

}  // namespace meander::sonar
