// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/pose.hpp"
#include "robot/contracts.hpp"
#include "robot/observation.hpp"
#include "sim/sim.hpp"

namespace meander {

/// One control cycle of a recorded run: the state at its end and the command that led there.
struct RunStep {
  double time = 0;  ///< [s] since the start of the run
  Pose2 pose_world;
  Pose2 odometry;
  Command command;
  double v = 0, w = 0;
  double clearance = 0;
  bool touching = false;
  NavigatorStatus status = NavigatorStatus::driving;
  std::vector<float> sonar;
  std::vector<std::uint8_t> whisker;  ///< empty for robots without
  std::vector<double> light;          ///< empty for robots without; exact, so that a map can be made from it again
};

/// How a drive went. The keys of its JSON line bear these names.
struct Run {
  std::string navigator;
  std::string guide;
  std::uint64_t seed = 0;
  bool success = false;  ///< the guide finished and says the task is done
  std::string reason;    ///< why it ended
  int reached = 0;       ///< subgoals reached
  int subgoals = 0;
  double time = 0;    ///< [s]
  double length = 0;  ///< true way [m]
  int contacts = 0;
  int fault_contacts = 0;
  int trapped = 0;           ///< times the navigator said that it is trapped
  double clearance_min = 0;  ///< [m], hull to obstacle
  double clearance_mean = 0;
  double turning = 0;        ///< sum |change of heading| [rad]
  double jerk = 0;           ///< mean |second difference of v| / period^2 [m/s^3]
  double cpu_per_cycle = 0;  ///< [s] of navigator and guide; not part of the hash
  int cycles = 0;
  std::uint64_t hash = 0;        ///< of every state of the run
  std::uint64_t world_hash = 0;  ///< of the world at its start
  double robot_radius = 0;       ///< [m], for the picture
  RobotOptions robot;            ///< how the robot was set up
  SimOptions sim;
  std::vector<Subgoal> goals;  ///< distinct subgoals in the order given, world frame at the start
  std::vector<RunStep> steps;
};

}  // namespace meander
