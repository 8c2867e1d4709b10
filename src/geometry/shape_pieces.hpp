// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "geometry/shape_index.hpp"

namespace meander {

/// A shape cut into the pieces of the index. Owner and material are left 0.
struct ShapePieces {
  std::vector<Wall> walls;
  std::optional<Pole> pole;
  Box box;
};
ShapePieces pieces_of(const Shape& shape);

/// The first piece on a ray, found by showing it the pieces in any order: of equally near ones the one of the lowest
/// owner counts.
class NearestHit {
 public:
  NearestHit(const Vec2& origin, const Vec2& direction, double max_range)
      : origin_(origin), direction_(direction), range_(max_range) {}

  void meet(const Wall& wall);
  void meet(const Pole& pole);
  std::optional<RayHit> hit() const;

 private:
  void take(double range, double cosine, std::uint32_t owner);

  Vec2 origin_;
  Vec2 direction_;
  double range_;
  double cosine_ = 0;  ///< of the incidence
  std::uint32_t owner_ = 0;
  bool found_ = false;
};

}  // namespace meander
