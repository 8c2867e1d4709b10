// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "geometry/pose.hpp"

namespace meander {

/// [KRR98] The local tangent graph's range profile: how far a disc is free to go in every direction. All in the frame
/// of the disc; direction 0 is the one asked for, the others follow counter-clockwise.
class FreeWays {
 public:
  /// So many directions, each looked at as far as `reach` [m].
  FreeWays(int directions, double reach);

  void look(const std::vector<Vec2>& points, double radius, double first_bearing);

  int count() const { return static_cast<int>(ways_.size()); }
  double step() const { return step_; }  ///< between directions [rad]
  double reach() const { return reach_; }
  double way(int k) const { return ways_[at(k)]; }
  double bearing(int k) const { return wrap_angle(first_ + k * step_); }
  Vec2 place(int k, double way) const;
  int nearest(double bearing) const;

 private:
  void shorten(const Vec2& point, double radius);
  std::size_t at(int k) const { return static_cast<std::size_t>((k % count() + count()) % count()); }

  double step_;
  double reach_;
  double first_ = 0;
  std::vector<double> ways_;
};

}  // namespace meander
