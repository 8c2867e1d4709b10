// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "polar/sonar_memory.hpp"
#include "polar/steering.hpp"

namespace meander {

/// TangentBug [KRR98] on sonar: towards the subgoal past the ends of what is in the way, and along walls where there is
/// no way nearer. Gets out of traps of any size, as far as its odometry is right.
struct TangentBugOptions {
  int directions = 72;
  double reach = 1.9;
  double clearance = 0.06;
  double jump = 0.17;
  double constancy = 0.53;
  double follow_look = 0.87;
  double leave = 0.16;
  double loop = 0.5;
  double half_cone = 0;
  double patience = 15;
  double progress = 0.3;
  SteeringOptions steering{.turn_gain = 1.1, .margin = 0.09, .headway = 0.42, .caution = 0.08};
  SonarMemoryOptions memory{.scans = 17, .contradictions = 1};
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TangentBugOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"directions", "", "in which the free way is looked at", 8, 720}, o.directions);
  visit(Field{"reach", "m", "how far the readings are trusted", 0.1, 100}, o.reach);
  visit(Field{"clearance", "m", "hull distance at which walls are passed", 0, 10}, o.clearance);
  visit(Field{"jump", "m", "neighbours whose free ways differ by more are the end of an obstacle", 0, 100}, o.jump);
  visit(Field{"constancy", "m", "another end is taken only when its way is shorter by this", 0, 100}, o.constancy);
  visit(Field{"follow_look", "m", "free way that makes a direction good enough along a wall", 0.01, 100},
        o.follow_look);
  visit(Field{"leave", "m", "a wall is left when a place so much nearer to the subgoal than any of it is in reach", 0,
              100},
        o.leave);
  visit(Field{"loop", "m", "coming so near to where following began means that there is no way", 0, 100}, o.loop);
  visit(Field{"half_cone", "rad", "half angle within which an echo may have come from", 0, 1.5}, o.half_cone);
  visit(Field{"patience", "s", "trapped after so long at the same place", 0.1, 1e6}, o.patience);
  visit(Field{"progress", "m", "what counts as another place", 0, 100}, o.progress);
  visit(Field{"steering", "", "how the direction is driven"}, o.steering);
  visit(Field{"memory", "", "what is remembered of the sonar"}, o.memory);
}

/// A navigator for this platform.
Navigator tangent_bug(const Platform& platform, const TangentBugOptions& options = {});

}  // namespace meander
