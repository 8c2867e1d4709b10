// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>

#include "robot/observation.hpp"
#include "robot/platform.hpp"

namespace meander {

struct PredictionOptions {
  bool enabled = true;
  int latency = -1;
  int periods = 8;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PredictionOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"enabled", "", "plan for where the robot will be when the command takes effect"}, o.enabled);
  visit(Field{"latency", "", "cycles until a command takes effect; -1: found out by watching the odometry", -1, 3},
        o.latency);
  visit(Field{"periods", "", "recent control periods in the running average", 1, 1000}, o.periods);
}

/// Pose in the odometry frame and velocities at one moment.
struct Prediction {
  Pose2 pose;
  double v = 0;
  double w = 0;
  double period = 0.33;  ///< average of the recent control cycles [s]
};

/// Configuration prediction [LM99]: where the robot will be, and how fast, when the command computed now takes effect.
/// The commands still on their way are integrated with the body's acceleration ramps over the average of the recent
/// periods.
class Predictor {
 public:
  Predictor(const Platform& platform, const PredictionOptions& options);

  Prediction predict(const Observation& observation);
  /// What was commanded in answer to the last observation.
  void commanded(const Command& command);
  void reset();
  int latency() const;

 private:
  static constexpr int kMostLatency = 3;
  void watch(const Observation& observation);

  Body body_;
  PredictionOptions options_;
  double standard_period_;
  double period_;
  int seen_ = 0;
  Odometry last_;
  std::array<Command, kMostLatency + 1> sent_{};     ///< the latest first
  std::array<double, kMostLatency + 1> surprise_{};  ///< fading sum of errors of each latency
};

}  // namespace meander
