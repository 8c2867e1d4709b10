// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "mapping/sonar_model.hpp"
#include "robot/observation.hpp"

namespace meander {

/// Readings that were taken one after the other while the robot moved, as one scan from where it is now.
class SweepMaker {
 public:
  SweepMaker(const RingLayout& ring, double range_max);

  /// Every transducer takes the reading whose axis points most nearly its way, lengthened by what the robot has driven
  /// along that axis since. No echo stays no echo. Readings that are no number count as none. The result is valid until
  /// the next call. Throws ArgumentError when the readings are not those of the ring.
  SonarSweep sweep(const Readings& readings, const Pose2& now);

 private:
  double seen_from(const Readings& readings, std::size_t index, double bearing, const Pose2& now) const;

  RingLayout ring_;
  double range_max_;
  std::vector<double> ranges_;
};

}  // namespace meander
