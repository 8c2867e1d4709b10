// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cmath>
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
  /// The same for points from elsewhere, in the odometry frame; all count as new.
  void map(std::span<const Vec2> points, const Pose2& odometry_from_map, const Vec2& robot_now);
  std::span<const MappedPoint> points() const { return points_; }
  /// From the hull at the origin to the nearest point [m].
  double clearance() const { return std::sqrt(nearest_square_) - radius_; }

 private:
  void begin(const Pose2& odometry_from_map, const Vec2& robot_now);
  void add(const Vec2& position, int age);
  bool new_place(const Vec2& p);

  Vec2 origin_{0, 0}, x_axis_{1, 0}, y_axis_{0, 1};  ///< of the map, in the odometry frame
  Vec2 robot_now_{0, 0};
  double radius_;
  double scope_;
  double merge_;
  double nearest_square_ = 0;  ///< from the origin to the nearest point, the scope if there is none [m^2]
  int side_ = 0;               ///< squares of the merging raster along a side
  std::vector<std::uint64_t> raster_;
  std::vector<MappedPoint> points_;
};

}  // namespace meander
