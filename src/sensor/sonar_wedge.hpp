// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/shape_index.hpp"

namespace meander::sonar {

inline constexpr double kNever = std::numeric_limits<double>::infinity();
/// Nearer than this is contact, and things beyond a mirror stand at least this far from it [m].
inline constexpr double kContact = 1e-9;

/// Where a transducer listens from: local coordinates X along `ahead`, Y along `left`. The mirror image of a view is a
/// left-handed one, in which the image of a thing has the coordinates that the thing has in the original.
struct View {
  Vec2 origin;
  Vec2 ahead;
  Vec2 left;
  Vec2 local(const Vec2& p) const {
    const double x = p.x() - origin.x(), y = p.y() - origin.y();
    return {x * ahead.x() + y * ahead.y(), x * left.x() + y * left.y()};
  }
};

/// What is looked at: directions s = Y / X from `low` to `high`, X > 0, beyond the screen normal . P >= offset (local).
struct Wedge {
  double low;
  double high;
  Vec2 normal{0, 0};
  double offset = -1;
  bool screened() const { return normal.x() != 0 || normal.y() != 0; }
};

/// A wall as cones need it.
struct Face {
  Vec2 a, b;
  Vec2 along;  ///< unit vector a -> b
  double length;
  std::uint32_t kind;  ///< index of its reflector
  bool convex_a, convex_b;
  bool solid;  ///< border of a solid, which lies to its left
  Face(const Wall& wall)
      : a(wall.a),
        b(wall.b),
        along(wall.b - wall.a),
        length(along.norm()),
        kind(wall.material),
        convex_a(wall.convex_a),
        convex_b(wall.convex_b),
        solid(wall.solid) {
    along /= length;
  }
};

/// How a material answers one reading.
struct Reflector {
  double strength = 1;   ///< share of the ranges below up to which it is heard
  double tan_limit = 0;  ///< of the largest |incidence| that answers
  double sin_limit = 0;
};

/// What answers, and up to where.
struct Hearing {
  bool incidence = true;    ///< walls answer within their limit only
  double near_field = 0;    ///< nearer than this all incidences answer [m]
  double corner_range = 0;  ///< convex corners answer up to here [m]
  double range = 0;         ///< walls and discs up to here [m]
  double strength = 1;      ///< what mirrors on the way left of the sound
};

/// The part of a wall or disc within a wedge. In (s, w) = (Y/X, 1/X) straight lines stay straight and nearer is greater
/// w: a wall hides by a linear function. A disc is given by the chord between its tangent points, and by itself.
struct Piece {
  double low, high;          ///< directions s it spans
  double w_low, w_high;      ///< 1/X of the wall or chord there
  double near;               ///< least distance [m]
  double far_squared;        ///< largest distance of the wall or chord, squared
  Vec2 center{0, 0};         ///< of a disc, local
  double radius = 0;         ///< of a disc; 0: wall
  std::uint32_t source = 0;  ///< index of the wall or disc

  bool disc() const { return radius > 0; }
  double w(double s) const { return s == high ? w_high : w_low + (s - low) * ((w_high - w_low) / (high - low)); }
};

/// Something that may answer: a part of a piece, or a corner.
struct Echo {
  double range;         ///< nothing of it is heard nearer than this; exact once settled
  Vec2 at;              ///< its nearest point, local; of a disc: some point in that direction
  Vec2 low, high;       ///< ends of what answers, in rising direction; of a disc: some points in those directions
  std::uint32_t piece;  ///< kCorner: a point
  static constexpr std::uint32_t kCorner = ~0u;
};

/// Distance of the point (s, w).
inline double distance_at(double s, double w) { return std::sqrt(1 + s * s) / w; }

/// Distance of a disc's front in direction s, which must meet it.
double front_of(const Piece& disc, double s);

/// Collects what stands in one wedge. The vectors keep their memory from use to use.
struct WedgeView {
  View view;
  Wedge wedge;
  Hearing hearing;
  std::span<const Reflector> reflectors;
  std::vector<Piece> pieces;
  std::vector<Echo> echoes;

  /// With room for the usual number from the first use on, so that scans soon cease to allocate.
  WedgeView() {
    pieces.reserve(64);
    echoes.reserve(64);
  }
  void start(const View& from, const Wedge& in, const Hearing& how, std::span<const Reflector> of);
  /// Adds what of it lies in the wedge and is nearer than `most`.
  void add(const Face& face, std::uint32_t source, double most);
  void add(const Pole& pole, std::uint32_t source, double most);
  void add_corner(const Vec2& corner, std::uint32_t kind, double most);
};

}  // namespace meander::sonar
