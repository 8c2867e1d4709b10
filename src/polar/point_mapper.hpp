// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "polar/polar_layout.hpp"
#include "polar/sonar_memory.hpp"

namespace meander {

/// The remembered points as they will lie around the robot.
struct MappedPoint {
  Vec2 position{0, 0};  ///< in the frame of the map
  int age = 0;          ///< of its scan, 0 the newest
};

/// Carries remembered points into the frame of the map: origin at the predicted position, x axis towards the target.
class PointMapper {
 public:
  PointMapper(double body_radius, double scope, double merge, std::size_t most);

  /// Points beyond the scope are left out, and those within the robot's body as it is now: they are errors [LM99].
  void map(const SonarMemory& memory, const Pose2& odometry_from_map, const Vec2& robot_now);
  std::span<const MappedPoint> points() const { return points_; }
  /// From the hull at the origin to the nearest point [m].
  double clearance() const { return nearest_ - radius_; }

 private:
  bool new_place(const Vec2& p);

  double radius_;
  double scope_;
  double merge_;
  double nearest_ = 0;  ///< from the origin to the nearest point, the scope if there is none [m]
  int side_ = 0;        ///< squares of the merging raster along a side
  std::vector<std::uint64_t> raster_;
  std::vector<MappedPoint> points_;
};

}  // namespace meander
