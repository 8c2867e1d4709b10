// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>

#include "geometry/pose.hpp"
#include "render/draw_list.hpp"
#include "render/theme.hpp"

namespace meander {

/// A subgoal as it is drawn.
struct TrackGoal {
  Vec2 position{0, 0};
  double tolerance = 0.25;  ///< [m]
  bool reached = false;
};

/// What is drawn of a drive.
struct Track {
  std::span<const Pose2> poses;      ///< of the robot, in order of time; not finite: a gap
  double radius = 0.25;              ///< of the robot's body [m]
  std::span<const TrackGoal> goals;  ///< numbered from 1 in this order
  std::span<const Vec2> contacts;    ///< where the robot was when it touched something
};

/// Adds a drive to the picture of its world: swept width, centre line, start, goals, contacts, the robot at the end.
void draw_track(DrawList& list, const Track& track, const Theme& theme);

/// Adds a round robot with its heading.
void draw_robot(DrawList& list, const Pose2& pose, double radius, const Theme& theme);

/// One sonar scan.
struct Scan {
  std::span<const Pose2> transducers;  ///< world poses at the moment each fired
  std::span<const double> ranges;      ///< [m], one per transducer
  double half_cone = 0.22;             ///< [rad]
  double range_max = 6.5;              ///< [m]; readings from here on heard nothing
};

/// Adds the cones of a scan, each with an arc where the echo came from. Throws ArgumentError when the numbers of
/// transducers and ranges differ.
void draw_readings(DrawList& list, const Scan& scan, const Theme& theme);

}  // namespace meander
