// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/work.hpp"
#include "robot/sonar_lessons.hpp"
#include "sim/sim.hpp"

namespace meander {

struct LessonOptions {
  int poses = 50;
  int window = 60;
  double resolution = 0.05;
  double slack = 0.07;
  double occupied = 0.25;
  double free = 0.015;
  double hidden = 0.008;
  std::uint64_t seed = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LessonOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"poses", "", "free places of the world from which the robot looks", 1, 100000}, o.poses);
  visit(Field{"window", "", "cells along a side of the square around the robot", 1, 1000}, o.window);
  visit(Field{"resolution", "m", "side of a cell", 0.005, 1}, o.resolution);
  visit(Field{"slack", "m", "cells so far behind the first surface on the line of sight still count as seen", 0, 10},
        o.slack);
  visit(Field{"occupied", "", "share of the occupied cells in sight that is taken", 0, 1}, o.occupied);
  visit(Field{"free", "", "share of the free cells in sight that is taken", 0, 1}, o.free);
  visit(Field{"hidden", "", "share of the hidden cells that is taken", 0, 1}, o.hidden);
  visit(Field{"seed", "", "of poses, sonars and the choice of cells"}, o.seed);
}

/// Puts the robot at random free poses of a world and adds what its sonars read there, with cells of the window around
/// it by line of sight. Cells under the robot's body and outside the bounds of the world are left out. Throws
/// ArgumentError when another ring or range was added before, and when the world has no room.
void add_lessons(SonarLessons& lessons, const World& world, const RobotOptions& robot, const LessonOptions& options,
                 const Work& work = {});

}  // namespace meander
