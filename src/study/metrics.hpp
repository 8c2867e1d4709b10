// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "sim/sim.hpp"
#include "study/run.hpp"

namespace meander {

/// The running figures of a drive, from its first state on.
class Metrics {
 public:
  Metrics(const RobotState& start, double time);
  /// One cycle later.
  void add(const RobotState& state, double time, double period);
  int contacts_before() const { return start_.contacts; }
  /// Writes time, length, contacts, clearance, turning and jerk.
  void write(Run& run) const;

 private:
  RobotState start_;
  RobotState last_;
  double start_time_;
  double last_time_;
  int cycles_ = 0;
  double clearance_min_;
  double clearance_sum_;
  double turning_ = 0;
  double jerk_sum_ = 0;
  int jerk_count_ = 0;
  double last_acceleration_ = 0;
};

}  // namespace meander
