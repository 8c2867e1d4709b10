// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "polar/sonar_memory.hpp"
#include "polar/trap_watch.hpp"
#include "robot/contracts.hpp"

namespace meander {

/// The dynamic window approach [FBT97]: of the velocities that can be reached within a cycle and from which the robot
/// can stop in time, those with the best sum of heading, free way and speed.
struct DynamicWindowOptions {
  int speeds = 11;
  int turns = 21;
  double heading_weight = 3;
  double distance_weight = 0.2;
  double speed_weight = 0.32;
  double margin = 0.07;
  double reach = 3.4;
  double half_cone = 0.218;
  double patience = 15;
  double progress = 0.10;
  SonarMemoryOptions memory{.scans = 12};
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DynamicWindowOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"speeds", "", "forward speeds tried in the window", 2, 1000}, o.speeds);
  visit(Field{"turns", "", "turning rates tried in the window", 3, 1000}, o.turns);
  visit(Field{"heading_weight", "", "of facing the subgoal in the end", 0, 1e6}, o.heading_weight);
  visit(Field{"distance_weight", "", "of the free way along the arc", 0, 1e6}, o.distance_weight);
  visit(Field{"speed_weight", "", "of going fast", 0, 1e6}, o.speed_weight);
  visit(Field{"margin", "m", "hull distance that counts as contact", 0, 10}, o.margin);
  visit(Field{"reach", "m", "a longer free way is not worth more", 0.1, 100}, o.reach);
  visit(Field{"half_cone", "rad", "half angle within which an echo may have come from", 0, 1.5}, o.half_cone);
  visit(Field{"patience", "s", "trapped after so long without progress", 0.1, 1e6}, o.patience);
  visit(Field{"progress", "m", "what counts as progress towards the subgoal", 0, 100}, o.progress);
  visit(Field{"memory", "", "what is remembered of the sonar"}, o.memory);
}

/// A navigator for this platform.
Navigator dynamic_window(const Platform& platform, const DynamicWindowOptions& options = {});

}  // namespace meander
