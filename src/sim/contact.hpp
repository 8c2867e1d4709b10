// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/shape_index.hpp"

namespace meander {

/// A body is stopped this far from a surface [m]: rounding can then never push it in.
inline constexpr double kContactSkin = 5e-7;
/// Nearer than this [m] is contact.
inline constexpr double kContactGap = 1e-6;
/// A contact episode ends when the gap is wider than this [m].
inline constexpr double kContactRelease = 1e-3;

/// Which share of the straight way `by` a point at `from` may go until it is within `reach` of the target; kFreeWay
/// when it never is on the way. Nearer than `reach` already: 0 when the way leads nearer still, free otherwise. Exact,
/// no iteration.
double way_to_point(const Vec2& from, const Vec2& by, double reach, const Vec2& point);
double way_to_segment(const Vec2& from, const Vec2& by, double reach, const Vec2& a, const Vec2& b);
inline constexpr double kFreeWay = 2;

/// The walls and poles a disc may meet soon.
class Surroundings {
 public:
  void gather(const ShapeIndex& walls, const Vec2& center, double radius) {
    walls.gather(center, radius, walls_, poles_);
  }
  /// Share of the straight way that a disc of this radius may go.
  double way(const Vec2& from, const Vec2& by, double radius) const;

 private:
  std::vector<Wall> walls_;
  std::vector<Pole> poles_;
};

}  // namespace meander
