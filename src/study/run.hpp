// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/pose.hpp"
#include "robot/observation.hpp"
#include "robot/contracts.hpp"

namespace meander {

/// One control cycle of a recorded run.
struct RunStep {
  double time;
  Pose2 pose_world;
  Pose2 odometry;
  Command command;
  double v, w;
  double clearance;
  bool touching;
  NavigatorStatus status;
  std::vector<float> sonar;
};

/// How a drive went. The keys of its JSON line bear these names.
struct Run {
  std::string navigator;
  std::string guide;
  std::uint64_t seed = 0;
  bool success = false;          ///< the guide finished and says the task is done
  std::string reason;            ///< why it ended
  int reached = 0;               ///< subgoals reached
  int subgoals = 0;
  double time = 0;               ///< [s]
  double length = 0;             ///< true way [m]
  int contacts = 0;
  int fault_contacts = 0;
  double clearance_min = 0;      ///< [m], hull to obstacle
  double clearance_mean = 0;
  double turning = 0;            ///< sum |change of heading| [rad]
  double jerk = 0;               ///< mean |second difference of v| / period^2 [m/s^3]
  double cpu_per_cycle = 0;      ///< [s] of navigator and guide; not part of the hash
  std::uint64_t hash = 0;        ///< of every state of the run
  double robot_radius = 0;       ///< [m], for the picture
  std::vector<Subgoal> goals;    ///< distinct subgoals in the order given, world frame at the start
  std::vector<RunStep> steps;
};

}  // namespace meander
