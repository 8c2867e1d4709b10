// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "robot/kinematics.hpp"

namespace meander {
namespace {

constexpr double kFading = 0.9;  ///< how much of the past surprise is kept per cycle
constexpr int kParts = 4;        ///< arcs per predicted cycle

}  // namespace

Predictor::Predictor(const Platform& platform, const PredictionOptions& options)
    : body_(platform.body), options_(options), standard_period_(platform.period), period_(platform.period) {}

void Predictor::reset() {
  period_ = standard_period_;
  seen_ = 0;
  sent_ = {};
  surprise_ = {};
}

int Predictor::latency() const {
  if (!options_.enabled) return 0;
  if (options_.latency >= 0) return options_.latency;
  return static_cast<int>(std::min_element(surprise_.begin(), surprise_.end()) - surprise_.begin());
}

/// Which latency explains best how the velocities changed during the cycle that ends here?
void Predictor::watch(const Observation& observation) {
  const double dt = observation.period;
  if (!(dt > 0)) return;
  const double share = 1.0 / std::min(seen_ + 1, options_.periods);
  period_ += share * (dt - period_);
  if (seen_++ == 0) return;
  for (std::size_t d = 0; d < surprise_.size(); ++d) {
    const double v = ramp(last_.v, sent_[d].v, body_.a_v * dt) - observation.odometry.v;
    const double w = ramp(last_.w, sent_[d].w, body_.a_w * dt) - observation.odometry.w;
    surprise_[d] = kFading * surprise_[d] + v * v + body_.radius * body_.radius * w * w;
  }
}

Prediction Predictor::predict(const Observation& observation) {
  watch(observation);
  last_ = observation.odometry;
  Prediction p{observation.odometry.pose, observation.odometry.v, observation.odometry.w, period_};
  for (int k = latency(); k > 0; --k) {
    const Command& command = sent_[static_cast<std::size_t>(k - 1)];
    for (int part = 0; part < kParts; ++part) {
      const double dt = period_ / kParts;
      const Ramped v = ramped(p.v, command.v, body_.a_v, dt), w = ramped(p.w, command.w, body_.a_w, dt);
      p.pose = arc(p.pose, v.mean, w.mean, dt);
      p.v = v.end;
      p.w = w.end;
    }
  }
  return p;
}

void Predictor::commanded(const Command& command) {
  std::copy_backward(sent_.begin(), sent_.end() - 1, sent_.end());
  sent_.front() = limited(command, body_);
}

}  // namespace meander
