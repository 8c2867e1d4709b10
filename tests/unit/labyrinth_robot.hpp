// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once

#include "sim/sim_robot.hpp"

namespace meander {

/// A round robot of that radius [m] with a Nomad's ring of sonars that hear every wall, for labyrinths.
inline RobotOptions labyrinth_robot(double radius = 0.2) {
  RobotOptions robot;
  robot.platform = platform("nomad200");
  robot.platform.body.radius = robot.platform.bumper.radius = radius;
  robot.platform.sonar.radius = radius - 0.03;
  robot.sonar = sonar_preset("nomad");
  robot.sonar.incidence = false;
  robot.sonar.corner_range = 0;
  robot.sonar.firing = Firing::simultaneous;
  return robot;
}

}  // namespace meander
