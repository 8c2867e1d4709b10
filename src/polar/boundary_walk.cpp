// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/boundary_walk.hpp"

#include <algorithm>
#include <limits>

namespace meander {

void BoundaryWalk::advance(const Pose2& pose, const Vec2& target, const FreeWays& ways,
                           const std::vector<Vec2>& points) {
  driven_ += (pose.position() - here_).norm();
  here_ = pose.position();
  const Vec2 goal = inverse(pose) * target;
  const double distance = goal.norm(), bearing = angle_of(goal.y(), goal.x());
  reach_ = distance;
  for (int k = 0; k < ways.count(); ++k) {
    const double way = std::clamp(distance * sin_cos(ways.bearing(k) - bearing).cos, 0.0, ways.way(k));
    reach_ = std::min(reach_, (goal - ways.place(k, way)).norm());
  }
  nearest_ = std::min(nearest_, distance);
  for (const Vec2& point : points)
    if (point.norm() < std::min(kOwnWall, distance)) nearest_ = std::min(nearest_, (goal - point).norm());
}

/// The wall is the nearest thing on its side of the way: across a narrow place another may be nearer.
std::optional<int> BoundaryWalk::direction(const Pose2& pose, const FreeWays& ways, const std::vector<Vec2>& points,
                                           double look) {
  const double beside = angle_between(pose.heading, along_ + side_ * kPi / 2);
  double from = beside, nearest = std::numeric_limits<double>::infinity();
  for (const Vec2& point : points) {
    const double bearing = angle_of(point.y(), point.x());
    if (point.squaredNorm() >= nearest || std::abs(angle_between(beside, bearing)) > kBeside) continue;
    nearest = point.squaredNorm();
    from = bearing;
  }
  const int first = ways.nearest(from), turn = side_ > 0 ? -1 : 1;
  for (int i = 0; i < ways.count(); ++i) {
    const int k = first + turn * i;
    if (ways.way(k) < look) continue;
    along_ = pose.heading + ways.bearing(k);
    return k;
  }
  return std::nullopt;
}

}  // namespace meander
