// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"
#include "robot/contracts.hpp"
#include "robot/platform.hpp"

namespace meander {

/// Artificial potential field [K86] on the sonar readings of the present cycle alone: no memory, no map.
struct PotentialFieldOptions {
  double influence = 0.43;
  double attraction = 1;
  double repulsion = 0.0025;
  double attraction_reach = 0.4;
  double turn_gain = 0.63;
  double margin = 0.02;
  double headway = 0.1;
  double caution = 0.15;
  double half_cone = 0.2181661564992912;
  double range_min = 0.152;
  double patience = 15;
  double progress = 0.10;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PotentialFieldOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"influence", "m", "surfaces nearer to the hull than this push", 0.01, 10}, o.influence);
  visit(Field{"attraction", "", "strength of the pull", 0, 1000}, o.attraction);
  visit(Field{"repulsion", "", "strength of the push", 0, 1000}, o.repulsion);
  visit(Field{"attraction_reach", "m", "the pull is constant farther away, falls linearly nearer", 0.001, 100},
        o.attraction_reach);
  visit(Field{"turn_gain", "1/s", "turning rate per radian of heading error", 0.01, 100}, o.turn_gain);
  visit(Field{"margin", "m", "hull distance that braking keeps free", 0, 10}, o.margin);
  visit(Field{"headway", "s", "and more the faster the robot is: so many seconds of its way", 0, 10}, o.headway);
  visit(Field{"caution", "m", "hull distance below which the speed falls", 0, 10}, o.caution);
  visit(Field{"half_cone", "rad", "half angle within which an echo may have come from", 0, 1.5}, o.half_cone);
  visit(Field{"range_min", "m", "least range of the sonars: what reads so near may touch the hull", 0, 10},
        o.range_min);
  visit(Field{"patience", "s", "trapped after so long without progress", 0.1, 1e6}, o.patience);
  visit(Field{"progress", "m", "what counts as progress towards the subgoal", 0, 100}, o.progress);
}

/// A navigator for this platform.
Navigator potential_field(const Platform& platform, const PotentialFieldOptions& options = {});

}  // namespace meander
