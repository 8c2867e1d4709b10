// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <vector>

#include "mapping/sonar_model.hpp"
#include "robot/observation.hpp"

namespace meander {

/// Readings that were taken one after the other while the robot moved, as one scan from where it is now.
class SweepMaker {
 public:
  SweepMaker(const RingLayout& ring, double range_max);

  /// Every transducer takes the reading whose axis points most nearly its way, lengthened by what the robot has driven
  /// along that axis since. No echo stays no echo: what reads `range_max` or, where the sonars tell it, their maximum.
  /// Readings that are no number count as none. The result is valid until the next call. Throws ArgumentError when the
  /// readings are not those of the ring.
  SonarSweep sweep(const Readings& readings, const Pose2& now);

 private:
  /// What is no echo, from here on [m].
  double silence(const Readings& readings) const { return std::min(range_max_, readings.sonar_max); }
  double seen_from(const Readings& readings, std::size_t index, double bearing, const Pose2& now) const;

  RingLayout ring_;
  double range_max_;
  std::vector<double> ranges_;
};

}  // namespace meander
