// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "robot/kinematics.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// Nobody asks for more [m/s]; keeps squares finite.
constexpr double kFastest = 1e6;

double within(double value, double least, double most) {
  return std::isfinite(value) ? std::clamp(value, least, most) : 0.0;
}

}  // namespace

Pose2 twist(const Pose2& pose, double v, double vy, double w, double dt) {
  // The chord of an arc of length s and turn 2h is s sin(h)/h long and points along heading + h.
  const double half = 0.5 * w * dt;
  const double sinc = half == 0 ? 1 : sin_cos(half).sin / half;
  const double ahead = v * dt * sinc, left = vy * dt * sinc;
  const SinCos along = sin_cos(pose.heading + half);
  return {pose.x + (ahead * along.cos - left * along.sin), pose.y + (ahead * along.sin + left * along.cos),
          wrap_angle(pose.heading + w * dt)};
}

double ramp(double value, double target, double most) { return value + std::clamp(target - value, -most, most); }

Ramped ramped(double value, double target, double rate, double dt) {
  const double most = rate * dt;
  const double gap = std::abs(target - value);
  if (gap >= most) {
    const double end = ramp(value, target, most);
    return {end, 0.5 * (value + end)};
  }
  // The ramp takes gap / rate of the time, the rest is driven at the target.
  return {target, target + 0.5 * (value - target) * (gap / most)};
}

RampedPlane ramped(const Vec2& value, const Vec2& target, double rate, double dt) {
  const Vec2 gap = target - value;
  if (gap.y() == 0) {  // a unicycle's: rounded as its speed alone
    const Ramped ahead = ramped(value.x(), target.x(), rate, dt);
    return {{ahead.end, target.y()}, {ahead.mean, target.y()}};
  }
  const double length = gap.norm();
  const Ramped way = ramped(0, length, rate, dt);
  return {way.end < length ? Vec2(value + way.end / length * gap) : target, value + way.mean / length * gap};
}

Command limited(const Command& command, const Body& body) {
  const double w = within(command.w, -body.w_max, body.w_max);
  if (body.drive == DriveKind::unicycle) return {within(command.v, body.v_min, body.v_max), w, 0};
  const double v = within(command.v, -kFastest, kFastest), vy = within(command.vy, -kFastest, kFastest);
  const double speed = std::sqrt(v * v + vy * vy);
  const double share = speed > body.v_max ? body.v_max / speed : 1;
  return {share * v, w, share * vy};
}

Pose2 between(const Pose2& from, const Pose2& to, double share) {
  if (share >= 1) return to;
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
          wrap_angle(from.heading + share * angle_between(from.heading, to.heading))};
}

}  // namespace meander
