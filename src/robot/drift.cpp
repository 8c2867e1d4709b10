// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "robot/drift.hpp"

#include <cmath>

#include "robot/kinematics.hpp"

namespace meander {
namespace {

struct Preset {
  const char* name;
  DriftOptions options;
};

// Random walk of 9.5 and 28 mm per root metre: what good and poor dead reckoning indoors comes to. Sources:
// docs/simulation.md.
constexpr Preset kPresets[] = {
    {"none", {}},
    {"good", {.distance_noise = 0.0095, .turn_noise = 0.01, .veer_noise = 0.0095}},
    {"poor",
     {.distance_bias = 0.02,
      .turn_bias = 0.01,
      .veer = 0.01,
      .distance_noise = 0.028,
      .turn_noise = 0.03,
      .veer_noise = 0.028}},
};

/// Length of the arc between two poses; negative when driven backwards.
double arc_length(const Pose2& from, const Pose2& to, double turn) {
  const double half = 0.5 * turn;
  const SinCos along = sin_cos(from.heading + half);
  const double chord = (to.x - from.x) * along.cos + (to.y - from.y) * along.sin;
  return half == 0 ? chord : chord * (half / sin_cos(half).sin);
}

}  // namespace

DriftOptions drift_preset(const std::string& name) {
  for (const Preset& preset : kPresets)
    if (name == preset.name) return preset.options;
  const auto names = drift_preset_names();
  fail("unknown drift preset '{}'; known: {}{}", name, listing(names), did_you_mean(name, names));
}

std::vector<std::string> drift_preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : kPresets) names.emplace_back(preset.name);
  return names;
}

Drift::Drift(const DriftOptions& options, std::uint64_t seed) : options_(options), stream_(seed, "odometry") {
  validate(options, "drift.");
}

Pose2 Drift::advance(const Pose2& odometry, const Pose2& from, const Pose2& to) {
  const double turn = angle_between(from.heading, to.heading);
  const double distance = arc_length(from, to, turn);
  const double root_distance = std::sqrt(std::abs(distance));
  const double distance_told = distance * (1 + options_.distance_bias) +  //
                               options_.distance_noise * root_distance * stream_.normal();
  const double turn_told = turn * (1 + options_.turn_bias) + options_.veer * distance +
                           options_.turn_noise * std::sqrt(std::abs(turn)) * stream_.normal() +
                           options_.veer_noise * root_distance * stream_.normal();
  return arc(odometry, distance_told, turn_told, 1);
}

}  // namespace meander
