// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Sensor models and scans that are made up, for maps.
#pragma once
#include <algorithm>
#include <cmath>

#include "mapping/sonar_map.hpp"

namespace meander {

inline constexpr double kNothing = 6.477;
inline const Platform& nomad() { return platform("nomad200"); }

/// Tells the same of every cell.
inline SonarModel telling(float log_odds) {
  return {.name = "same",
          .ring = nomad().sonar,
          .reach = 10,
          .evaluate = [log_odds](const SonarSweep&, const CellPlaces& cells, std::span<float> out) {
            std::fill(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(cells.size()), log_odds);
          }};
}

/// Something smooth of place and readings, between -0.2 and 0.2: nothing saturates.
inline SonarModel wavy() {
  return {.name = "wavy",
          .ring = nomad().sonar,
          .reach = 10,
          .evaluate = [](const SonarSweep& sweep, const CellPlaces& cells, std::span<float> out) {
            for (std::size_t i = 0; i < cells.size(); ++i)
              out[i] = 0.1F * std::sin(7 * cells.range[i] + static_cast<float>(sweep.ranges[3])) +
                       0.1F * std::cos(3 * cells.bearing[i]);
          }};
}

inline Observation seen_from(const Pose2& pose, double reading = kNothing) {
  Observation seen;
  seen.odometry.pose = pose;
  seen.readings.sonar.assign(16, reading);
  seen.readings.sonar_pose.assign(16, pose);
  return seen;
}

inline LocalMapOptions by(Fusion rule) {
  LocalMapOptions options;
  options.fusion.rule = rule;
  return options;
}

}  // namespace meander
