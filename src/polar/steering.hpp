// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <vector>

#include "base/fields.hpp"
#include "robot/contracts.hpp"
#include "robot/platform.hpp"

namespace meander {

struct SteeringOptions {
  double turn_gain = 1.5;
  double margin = 0.05;
  double headway = 0.2;
  double caution = 0.30;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SteeringOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"turn_gain", "1/s", "turning rate per radian of heading error", 0.01, 100}, o.turn_gain);
  visit(Field{"margin", "m", "hull distance that braking keeps free", 0, 10}, o.margin);
  visit(Field{"headway", "s", "way that braking leaves besides: so many seconds at the present speed", 0, 10},
        o.headway);
  visit(Field{"caution", "m", "hull distance below which the speed falls", 0, 10}, o.caution);
}

/// Turns a direction into a command: towards it, as fast as the error of heading, the subgoal and the points around
/// allow. For methods that say where to, not how fast.
class Steering {
 public:
  Steering(const Platform& platform, const SteeringOptions& options) : body_(platform.body), options_(options) {}

  /// `bearing` [rad] in the robot's frame; the way that is left to drive [m]; points in the robot's frame. One cycle
  /// under the command and then braking keep the margin from every point.
  Command towards(double bearing, double distance, const Observation& observation,
                  const std::vector<Vec2>& points) const;
  /// How far from the robot's centre points matter to `towards` [m].
  double reach(const Observation& observation) const;
  /// On the spot.
  Command turn(double bearing, const Observation& observation) const;

 private:
  double rate(double bearing, double period) const;
  double free_speed(double v, double w, const Observation& observation, const std::vector<Vec2>& points) const;

  Body body_;
  SteeringOptions options_;
};

/// The answer when the robot is within the tolerance of the subgoal: arrived, or turning to the heading asked for.
/// Nothing when it is not.
std::optional<NavigatorStep> arrival(const Observation& observation, const Subgoal& subgoal, const Body& body);

}  // namespace meander
