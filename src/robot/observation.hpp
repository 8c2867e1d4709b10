// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/pose.hpp"

namespace meander {

/// Velocity command. Unicycles take v and w; omnidirectional bodies take vx = v, vy and w.
struct Command {
  double v = 0;   ///< forward [m/s]
  double w = 0;   ///< counter-clockwise [rad/s]
  double vy = 0;  ///< to the left [m/s]; 0 for unicycles
  bool operator==(const Command&) const = default;
};

/// What the wheels tell: pose in the odometry frame (starts at the start pose) and velocities.
struct Odometry {
  Pose2 pose;
  double v = 0;   ///< forward [m/s]
  double w = 0;   ///< [rad/s]
  double vy = 0;  ///< to the left [m/s]; 0 for unicycles
};

/// One sensor suite's output of one control cycle. Arrays are in ring order, first transducer forward,
/// counter-clockwise.
struct Readings {
  std::vector<double> sonar;                                   ///< ranges [m]; the maximum range: no echo
  double sonar_max = std::numeric_limits<double>::infinity();  ///< that range, where the sonars tell it [m]
  std::vector<Pose2> sonar_pose;                               ///< odometry pose of the robot at which each was taken
  std::vector<std::uint8_t> bumper;                            ///< 1: pressed
  std::vector<std::uint8_t> whisker;                           ///< 1: bent
  std::vector<double> light;                                   ///< brightness, compressed by the logarithm
};

/// Everything the robot side gets to see in one control cycle.
struct Observation {
  double time = 0;    ///< [s] since the start
  double period = 0;  ///< length of the cycle that ends here [s]
  Odometry odometry;
  Readings readings;
};

}  // namespace meander
