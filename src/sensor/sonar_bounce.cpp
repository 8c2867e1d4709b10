// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_bounce.hpp"

namespace meander::sonar {
namespace {

/// Windows narrower than this are rounding [s].
constexpr double kSliver = 1e-9;

}  // namespace

View mirrored(const View& view, const Vec2& a, const Vec2& b) {
  const Vec2 normal = left_of(b - a).normalized();
  const auto flipped = [&](const Vec2& v) { return Vec2(v - 2 * normal.dot(v) * normal); };
  return {a + flipped(view.origin - a), flipped(view.ahead), flipped(view.left)};
}

double Bounce::through(const Candidates& list, const WedgeView& seen, const Piece& piece, double low, double high,
                       double shift, double most) {
  const Face& wall = list.faces().things[piece.source];
  const Vec2 a = seen.view.local(wall.a);
  Vec2 normal = left_of(seen.view.local(wall.b) - a).normalized();
  if (normal.dot(a) < 0) normal = -normal;
  // The wall has the same local coordinates in both views.
  const Wedge window{.low = low, .high = high, .normal = normal, .offset = normal.dot(a) + kContact};
  Hearing hearing = seen.hearing;
  hearing.strength *= seen.reflectors[wall.kind].strength;
  return mirrored_.first_echo(list, mirrored(seen.view, wall.a, wall.b), window, hearing, seen.reflectors, shift, most);
}

double Bounce::first_echo(const Candidates& list, const Cone& direct, double shift, double most) {
  const WedgeView& seen = direct.in_wedge();
  const double known = most;
  for (const Piece& piece : seen.pieces) {
    if (piece.disc() || piece.near >= most || seen.reflectors[list.faces().things[piece.source].kind].strength == 0)
      continue;
    shadows_.cast(piece, seen.pieces, known);
    double low = piece.low;
    for (const Interval& shadow : shadows_.intervals()) {
      if (shadow.low - low > kSliver) most = through(list, seen, piece, low, shadow.low, shift, most);
      low = std::max(low, shadow.high);
    }
    if (piece.high - low > kSliver) most = through(list, seen, piece, low, piece.high, shift, most);
  }
  return most;
}

}  // namespace meander::sonar
