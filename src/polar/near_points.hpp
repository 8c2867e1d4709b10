// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "polar/echo.hpp"
#include "polar/sonar_memory.hpp"

namespace meander {

/// What is remembered, as points in the frame of the robot at `pose`, no farther than `reach` from its centre. What
/// lies well inside the body cannot be there and is left out.
void points_near(const SonarMemory& memory, const Pose2& pose, double body_radius, double reach,
                 std::vector<Vec2>& points);

/// The newest readings as places within their cones: a thin thing stands as far beside the axis as the cone is wide.
/// Adds the ends of each cone that its neighbours do not rule out, no farther than `reach` from the robot's centre.
class ConeEnds {
 public:
  ConeEnds(const Platform& platform, double range_min, double half_cone);
  void add(const Observation& observation, double reach, std::vector<Vec2>& points);

 private:
  Platform platform_;
  EchoRule rule_;
  std::vector<Echo> echoes_;
};

/// How far a disc may drive along an arc until it touches one of the points: the way of its centre [m], at most `most`.
/// The robot starts at the origin and looks along x; curvature in 1/m, positive to the left. A point that is within
/// `radius` already stops only motion that leads nearer.
double free_arc(const std::vector<Vec2>& points, double curvature, double radius, double most);

}  // namespace meander
