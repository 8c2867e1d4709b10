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
    {"alice", {.veer = 0.0017453, .veer_noise = 0.017453, .slip = 0.225, .slip_spread = 0.025}},
};

/// The way between two poses in the body's own frame, along the arc: ahead and to the left; negative backwards and to
/// the right.
Vec2 way_between(const Pose2& from, const Pose2& to, double turn) {
  const double half = 0.5 * turn;
  const SinCos along = sin_cos(from.heading + half);
  const double stretch = half == 0 ? 1 : half / sin_cos(half).sin;
  const double dx = to.x - from.x, dy = to.y - from.y;
  return {(dx * along.cos + dy * along.sin) * stretch, (dy * along.cos - dx * along.sin) * stretch};
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

Drift::Drift(const DriftOptions& options, std::uint64_t seed, DriveKind drive)
    : options_(options), drive_(drive), stream_(seed, "odometry") {
  validate(options, "drift.");
  slip_bearing_ = options_.slip > 0 ? stream_.uniform(-kPi, kPi) : 0;
}

Vec2 Drift::slipped(const Vec2& told, double way) {
  if (options_.slip == 0 || way == 0) return told;
  // A random walk of 2/L rad^2 per metre: the mean of cos(change) falls to 1/e over L.
  slip_bearing_ += std::sqrt(2 * way / options_.slip_length) * stream_.normal();
  const double share = options_.slip + stream_.uniform(-options_.slip_spread, options_.slip_spread);
  const SinCos by = sin_cos(wrap_angle(slip_bearing_));
  return told + share * Vec2(told.x() * by.cos - told.y() * by.sin, told.x() * by.sin + told.y() * by.cos);
}

Pose2 Drift::advance(const Pose2& odometry, const Pose2& from, const Pose2& to) {
  const double turn = angle_between(from.heading, to.heading);
  const Vec2 driven = way_between(from, to, turn);
  const bool sideways = drive_ == DriveKind::omnidirectional;
  const double distance = sideways ? driven.norm() : driven.x();
  const double root_distance = std::sqrt(std::abs(distance));
  const double distance_told = distance * (1 + options_.distance_bias) +  //
                               options_.distance_noise * root_distance * stream_.normal();
  const double turn_told = turn * (1 + options_.turn_bias) + options_.veer * distance +
                           options_.turn_noise * std::sqrt(std::abs(turn)) * stream_.normal() +
                           options_.veer_noise * root_distance * stream_.normal();
  const Vec2 told = sideways && distance > 0 ? Vec2((distance_told / distance) * driven) : Vec2(distance_told, 0);
  const Vec2 reported = slipped(told, std::abs(distance));
  return twist(odometry, reported.x(), reported.y(), turn_told, 1);
}

}  // namespace meander
