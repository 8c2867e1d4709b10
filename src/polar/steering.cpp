// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/steering.hpp"

#include <algorithm>
#include <cmath>

#include "polar/near_points.hpp"

namespace meander {
namespace {

constexpr double kAligned = 0.05;     ///< [rad]
constexpr double kLeastShare = 0.15;  ///< of the speed, however near things are
constexpr int kTries = 8;

/// The turning rate from which braking ends at the bearing, approached without overshoot within a cycle.
double turning_rate(double bearing, double gain, double period, const Body& body) {
  const double most = std::min(body.w_max, std::sqrt(2 * body.a_w * std::abs(bearing)));
  return std::clamp(bearing * std::min(gain, 1 / period), -most, most);
}

}  // namespace

double Steering::rate(double bearing, double period) const {
  return turning_rate(bearing, options_.turn_gain, period, body_);
}

double Steering::reach(const Observation& observation) const {
  const double v = std::max(body_.v_max, observation.odometry.v);
  return body_.radius + options_.margin + v * (observation.period + options_.headway) + v * v / (2 * body_.a_v);
}

Command Steering::turn(double bearing, const Observation& observation) const {
  return {0, rate(bearing, observation.period), 0};
}

Command Steering::towards(double bearing, double distance, const Observation& observation,
                          const std::vector<Vec2>& points) const {
  const double w = rate(bearing, observation.period);
  const double aligned = std::max(0.0, sin_cos(bearing).cos);
  double gap = options_.caution;
  for (const Vec2& point : points) gap = std::min(gap, point.norm() - body_.radius);
  double v = body_.v_max * aligned * aligned;
  v = std::min(v, std::sqrt(2 * body_.a_v * distance));
  v = std::min(v, distance / (2 * observation.period));
  v *= std::clamp(gap / std::max(options_.caution, 1e-9), kLeastShare, 1.0);
  return {free_speed(v, w, observation, points), w, 0};
}

/// The largest speed up to v whose way in this cycle and braking after it are free.
double Steering::free_speed(double v, double w, const Observation& observation, const std::vector<Vec2>& points) const {
  for (int k = kTries; k > 0; --k) {
    const double candidate = v * k / kTries;
    if (candidate <= 0) break;
    const double fastest = std::max(candidate, observation.odometry.v);
    const double need = fastest * (observation.period + options_.headway) + candidate * candidate / (2 * body_.a_v);
    if (free_arc(points, w / candidate, body_.radius + options_.margin, need) >= need) return candidate;
  }
  return 0;
}

std::optional<NavigatorStep> arrival(const Observation& observation, const Subgoal& subgoal, const Body& body) {
  const Pose2& pose = observation.odometry.pose;
  if ((subgoal.position - pose.position()).norm() > subgoal.tolerance) return std::nullopt;
  const double error = subgoal.heading ? angle_between(pose.heading, *subgoal.heading) : 0;
  if (std::abs(error) <= kAligned) return NavigatorStep{{}, NavigatorStatus::arrived, {}};
  return NavigatorStep{
      {0, turning_rate(error, 1 / observation.period, observation.period, body), 0}, NavigatorStatus::driving, {}};
}

}  // namespace meander
