// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/metrics.hpp"

#include <algorithm>
#include <cmath>

namespace meander {

Metrics::Metrics(const RobotState& start, double time)
    : start_(start),
      last_(start),
      start_time_(time),
      last_time_(time),
      clearance_min_(start.clearance),
      clearance_sum_(start.clearance) {}

void Metrics::add(const RobotState& state, double time, double period) {
  const double acceleration = (state.v - last_.v) / period;
  if (cycles_ > 0) {
    jerk_sum_ += std::abs(acceleration - last_acceleration_) / period;
    ++jerk_count_;
  }
  ++cycles_;
  turning_ += std::abs(angle_between(last_.pose_world.heading, state.pose_world.heading));
  clearance_min_ = std::min(clearance_min_, state.clearance);
  clearance_sum_ += state.clearance;
  last_acceleration_ = acceleration;
  last_ = state;
  last_time_ = time;
}

void Metrics::write(Run& run) const {
  run.time = last_time_ - start_time_;
  run.length = last_.travelled - start_.travelled;
  run.contacts = last_.contacts - start_.contacts;
  run.fault_contacts = last_.fault_contacts - start_.fault_contacts;
  run.clearance_min = clearance_min_;
  run.clearance_mean = clearance_sum_ / (cycles_ + 1);
  run.turning = turning_;
  run.jerk = jerk_count_ > 0 ? jerk_sum_ / jerk_count_ : 0;
  run.cycles = cycles_;
}

}  // namespace meander
