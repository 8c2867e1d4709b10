// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "base/random.hpp"
#include "geometry/pose.hpp"

namespace meander {

/// Errors of dead reckoning. Systematic parts scale the motion, random parts add noise that grows with the root of the
/// way (Thrun, Burgard, Fox 2005, ch. 5.4: rotation and translation noise per unit of each).
struct DriftOptions {
  double distance_bias = 0;   ///< relative error of distances
  double turn_bias = 0;       ///< relative error of turns
  double veer = 0;            ///< [rad/m] turn reported per metre driven straight
  double distance_noise = 0;  ///< [m per root metre]
  double turn_noise = 0;      ///< [rad per root radian]
  double veer_noise = 0;      ///< [rad per root metre]
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
}

/// "none" (default), "good" or "poor"; throws ArgumentError that lists the known ones. Sources: docs/simulation.md.
DriftOptions drift_preset(const std::string& name);
std::vector<std::string> drift_preset_names();

/// Turns true motion into dead-reckoned motion. Copying it forks it.
class Drift {
 public:
  Drift(const DriftOptions& options, std::uint64_t seed);
  /// The odometry pose after the true motion from one pose to the next (a short arc, forwards or backwards).
  Pose2 advance(const Pose2& odometry, const Pose2& from, const Pose2& to);
  void add_to(Hash& hash) const { stream_.add_to(hash); }

 private:
  DriftOptions options_;
  Stream stream_;
};

}  // namespace meander
