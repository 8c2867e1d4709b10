// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shapes.hpp"

namespace meander {
namespace {

/// p -> offset + factor * R(angle) * p, applied to whole shapes. Mirror images do not exist, so factor > 0.
struct Similarity {
  Vec2 offset{0, 0};
  double factor = 1;
  double angle = 0;
  SinCos turn = sin_cos(angle);

  Vec2 operator()(const Vec2& p) const {
    return offset + factor * Vec2(turn.cos * p.x() - turn.sin * p.y(), turn.sin * p.x() + turn.cos * p.y());
  }
  std::vector<Vec2> operator()(std::vector<Vec2> points) const {
    for (Vec2& p : points) p = (*this)(p);
    return points;
  }
  Shape operator()(const Chain& c) const { return Chain{(*this)(c.points), c.closed}; }
  Shape operator()(const Polygon& p) const {
    Polygon result{(*this)(p.outer), {}};
    for (const auto& hole : p.holes) result.holes.push_back((*this)(hole));
    return result;
  }
  Shape operator()(const Rectangle& r) const {
    return Rectangle{(*this)(r.center), factor * r.size, angle == 0 ? r.heading : wrap_angle(r.heading + angle)};
  }
  Shape operator()(const Disc& d) const { return Disc{(*this)(d.center), factor * d.radius}; }
};

}  // namespace

Shape moved(const Shape& shape, const Vec2& by) { return std::visit(Similarity{.offset = by}, shape); }

Shape turned(const Shape& shape, double by, const Vec2& about) {
  Similarity turn{.angle = by};
  turn.offset = about - turn(about);
  return std::visit(turn, shape);
}

Shape scaled(const Shape& shape, double factor, const Vec2& about) {
  return std::visit(Similarity{.offset = (1 - factor) * about, .factor = factor}, shape);
}

}  // namespace meander
