// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <vector>

#include "render/draw_list.hpp"
#include "render/theme.hpp"
#include "robot/platform.hpp"

namespace meander {

/// What a picture must know of a robot.
struct RobotLook {
  double radius = 0.25;  ///< of its body [m]
  RingLayout ring;       ///< where its sonars sit
  double half_cone = 0.22;
  double range_max = 6.5;  ///< [m]; readings from here on heard nothing
};

/// Where the transducers of a ring are when the robot is at a pose.
std::vector<Pose2> transducer_poses(const RingLayout& layout, const Pose2& pose);

/// Adds the cones of one scan that was taken at a pose; nothing when the number of ranges is not that of the ring.
void draw_scan(DrawList& list, const RobotLook& look, const Pose2& pose, std::span<const double> ranges,
               const Theme& theme);

}  // namespace meander
