// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "polar/sonar_memory.hpp"
#include "polar/steering.hpp"
#include "polar/trap_watch.hpp"

namespace meander {

/// VFH+ [UB98]: a polar histogram of what was seen lately, from which free directions are picked by cost.
struct VfhPlusOptions {
  int sectors = 72;
  double window = 1.0;
  double enlarge = 0.02;
  double low = 0.45;
  double high = 1.0;
  int wide_valley = 11;
  double goal_weight = 5;
  double heading_weight = 2.3;
  double previous_weight = 2.6;
  double half_cone = 0.1;
  double patience = 15;
  double progress = 0.10;
  SteeringOptions steering{.turn_gain = 2.3, .margin = 0.10, .headway = 0.15, .caution = 0.33};
  SonarMemoryOptions memory{.scans = 6, .contradictions = 4};
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, VfhPlusOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"sectors", "", "of the histogram", 8, 720}, o.sectors);
  visit(Field{"window", "m", "what is farther does not count", 0.1, 100}, o.window);
  visit(Field{"enlarge", "m", "by how much more than the robot's radius obstacles are enlarged", 0, 10}, o.enlarge);
  visit(Field{"low", "", "a sector is free when its density is below this", 0, 1e6}, o.low);
  visit(Field{"high", "", "and blocked above this; between them it stays what it was", 0, 1e6}, o.high);
  visit(Field{"wide_valley", "sectors", "openings of more sectors than this have two edges to drive along", 1, 720},
        o.wide_valley);
  visit(Field{"goal_weight", "", "cost of turning away from the subgoal", 0, 1e6}, o.goal_weight);
  visit(Field{"heading_weight", "", "cost of turning", 0, 1e6}, o.heading_weight);
  visit(Field{"previous_weight", "", "cost of another direction than the last", 0, 1e6}, o.previous_weight);
  visit(Field{"half_cone", "rad", "half angle within which an echo may have come from", 0, 1.5}, o.half_cone);
  visit(Field{"patience", "s", "trapped after so long without progress", 0.1, 1e6}, o.patience);
  visit(Field{"progress", "m", "what counts as progress towards the subgoal", 0, 100}, o.progress);
  visit(Field{"steering", "", "how the direction is driven"}, o.steering);
  visit(Field{"memory", "", "what is remembered of the sonar"}, o.memory);
}

/// A navigator for this platform.
Navigator vfh_plus(const Platform& platform, const VfhPlusOptions& options = {});

}  // namespace meander
