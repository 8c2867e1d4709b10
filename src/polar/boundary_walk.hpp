// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "polar/free_ways.hpp"

namespace meander {

/// [KRR98] Following the boundary of an obstacle, which stays on one side, until a place is in reach that is nearer to
/// the target than all of the boundary so far. Places are those of the odometry frame.
class BoundaryWalk {
 public:
  /// `side` 1: the wall is on the left; `along`: direction to set out in [rad]; `nearest`: what a place must be nearer
  /// to the target than [m].
  BoundaryWalk(double side, double along, double nearest, const Vec2& begin)
      : side_(side), along_(along), nearest_(nearest), begin_(begin), here_(begin) {}

  double side() const { return side_; }
  double driven() const { return driven_; }  ///< since it began [m]

  /// Once per cycle: where the robot is now, what is near it and how far it is free to go, both in the robot's frame.
  void advance(const Pose2& pose, const Vec2& target, const FreeWays& ways, const std::vector<Vec2>& points);
  /// Is a place in reach that is nearer to the target by `leave` [m] than all of the boundary?
  bool over(double leave) const { return reach_ < nearest_ - leave; }
  /// Back to within `loop` metres of where it began: there is no way.
  bool came_round(double loop) const { return driven_ > kRound * loop && (here_ - begin_).norm() < loop; }
  /// The first direction with a free way of `look` metres, seen from the wall on; none: nowhere.
  std::optional<int> direction(const Pose2& pose, const FreeWays& ways, const std::vector<Vec2>& points, double look);

 private:
  static constexpr double kRound = 8;      ///< a way round is at least so many times the size of `loop`
  static constexpr double kBeside = 1.9;   ///< how far from beside the way the wall may be [rad]
  static constexpr double kOwnWall = 1.2;  ///< what is nearer belongs to the wall that is followed [m]

  double side_;
  double along_;  ///< direction taken last [rad]
  double nearest_;
  double reach_ = 0;  ///< from the target to the nearest place in reach now [m]
  Vec2 begin_;
  Vec2 here_;
  double driven_ = 0;
};

}  // namespace meander
