// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "base/random.hpp"
#include "geometry/pose.hpp"
#include "robot/platform.hpp"

namespace meander {

/// Errors of dead reckoning. Systematic parts scale the motion, random parts add noise that grows with the root of the
/// way (Thrun, Burgard, Fox 2005, ch. 5.4: rotation and translation noise per unit of each). The slip is an error
/// vector of a share of every motion whose direction, seen from the motion, wanders ([Z] section 1: 20-25 %).
struct DriftOptions {
  double distance_bias = 0;   ///< relative error of distances
  double turn_bias = 0;       ///< relative error of turns
  double veer = 0;            ///< [rad/m] turn reported per metre driven straight
  double distance_noise = 0;  ///< [m per root metre]
  double turn_noise = 0;      ///< [rad per root radian]
  double veer_noise = 0;      ///< [rad per root metre]
  double slip = 0;            ///< length of the slip vector, as a share of the way
  double slip_spread = 0;     ///< the share varies by up to this much, evenly
  double slip_length = 1;     ///< way over which the direction of the slip stays alike [m]
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DriftOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"distance_bias", "", "relative error of distances", -0.9, 10}, o.distance_bias);
  visit(Field{"turn_bias", "", "relative error of turns", -0.9, 10}, o.turn_bias);
  visit(Field{"veer", "rad/m", "false turn per metre", -10, 10}, o.veer);
  visit(Field{"distance_noise", "m/m^0.5", "random error of distances per root metre", 0, 10}, o.distance_noise);
  visit(Field{"turn_noise", "rad/rad^0.5", "random error of turns per root radian", 0, 10}, o.turn_noise);
  visit(Field{"veer_noise", "rad/m^0.5", "random false turn per root metre", 0, 10}, o.veer_noise);
  visit(Field{"slip", "", "length of the error vector that every motion gets, as a share of the motion", 0, 10},
        o.slip);
  visit(Field{"slip_spread", "", "how far that share varies, evenly", 0, 10}, o.slip_spread);
  visit(Field{"slip_length", "m", "way over which the error vector keeps its direction", 1e-3, 1000}, o.slip_length);
}

/// "none" (default), "good", "poor" or "alice"; throws ArgumentError that lists the known ones. Sources:
/// docs/simulation.md.
DriftOptions drift_preset(const std::string& name);
std::vector<std::string> drift_preset_names();

/// Turns true motion into dead-reckoned motion. Copying it forks it.
class Drift {
 public:
  /// A unicycle only ever reports motion along its heading.
  Drift(const DriftOptions& options, std::uint64_t seed, DriveKind drive = DriveKind::unicycle);
  /// The odometry pose after the true motion from one pose to the next (short; a unicycle's is an arc).
  Pose2 advance(const Pose2& odometry, const Pose2& from, const Pose2& to);
  void add_to(Hash& hash) const { stream_.add_to(hash); }

 private:
  Vec2 slipped(const Vec2& told, double way);

  DriftOptions options_;
  DriveKind drive_;
  Stream stream_;
  double slip_bearing_;  ///< of the slip, relative to the motion [rad]
};

}  // namespace meander
