// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/potential_field.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "polar/echo.hpp"
#include "robot/kinematics.hpp"

namespace meander {
namespace {

class PotentialField {
 public:
  PotentialField(const Platform& platform, const PotentialFieldOptions& options)
      : platform_(platform), options_(options) {}

  void reset() { *this = PotentialField(platform_, options_); }

  NavigatorStep step(const Observation& observation, const Subgoal& subgoal) {
    const Vec2 to_subgoal = inverse(observation.odometry.pose) * subgoal.position;
    const double distance = to_subgoal.norm();
    if (distance <= subgoal.tolerance) return arrive(observation, subgoal);
    if (no_progress(observation, subgoal, distance))
      return {{},
              NavigatorStatus::trapped,
              fmt::format("no progress for {:g} s, {:.2f} m from the subgoal: pull and push balance", options_.patience,
                          distance)};
    read_echoes(observation, platform_, {.range_min = options_.range_min, .half_cone = options_.half_cone}, echoes_);
    const Vec2 force = pull(to_subgoal, distance) + push();
    return {command(observation, force, distance), NavigatorStatus::driving, {}};
  }

 private:
  NavigatorStep arrive(const Observation& observation, const Subgoal& subgoal) const {
    constexpr double kAligned = 0.05;  // [rad]
    if (!subgoal.heading) return {{}, NavigatorStatus::arrived, {}};
    const double error = angle_between(observation.odometry.pose.heading, *subgoal.heading);
    if (std::abs(error) <= kAligned) return {{}, NavigatorStatus::arrived, {}};
    return {{0, turn(error, observation.period), 0}, NavigatorStatus::driving, {}};
  }

  bool no_progress(const Observation& observation, const Subgoal& subgoal, double distance) {
    if (subgoal.position != goal_ || distance < nearest_ - options_.progress) {
      goal_ = subgoal.position;
      nearest_ = distance;
      since_ = observation.time;
    }
    return observation.time - since_ > options_.patience;
  }

  Vec2 pull(const Vec2& to_subgoal, double distance) const {
    return to_subgoal * (options_.attraction / std::max(distance, options_.attraction_reach));
  }

  /// [K86] eq. (20): eta (1/rho - 1/rho_0) / rho^2 away from each surface nearer than rho_0.
  Vec2 push() const {
    Vec2 force{0, 0};
    for (const Echo& echo : echoes_) {
      const double rho = std::max(echo.axis.norm() - platform_.body.radius, kLeastGap);
      if (rho >= options_.influence) continue;
      const double size = options_.repulsion * (1 / rho - 1 / options_.influence) / (rho * rho);
      force -= std::min(size, kMostPush * options_.attraction) * echo.axis.normalized();
    }
    return force;
  }

  /// Turn towards the force; drive as fast as heading error, surfaces and the subgoal allow.
  Command command(const Observation& observation, const Vec2& force, double distance) const {
    const Body& body = platform_.body;
    const double error = angle_of(force.y(), force.x());
    const double w = turn(error, observation.period);
    const double aligned = std::max(0.0, sin_cos(error).cos);
    double v = body.v_max * aligned * aligned;
    v = std::min(v, std::sqrt(2 * body.a_v * distance));
    v = std::min(v, body.v_max * std::clamp(nearest_gap() / std::max(options_.caution, 1e-9), 0.15, 1.0));
    return {free_speed(observation, v, w), w, 0};
  }

  double turn(double error, double period) const {
    const double most = std::min(platform_.body.w_max, std::sqrt(2 * platform_.body.a_w * std::abs(error)));
    return std::clamp(error * std::min(options_.turn_gain, 1 / period), -most, most);
  }

  double nearest_gap() const {
    double gap = options_.caution;
    for (const Echo& echo : echoes_) gap = std::min(gap, echo.gap);
    return gap;
  }

  /// The largest speed up to v whose way, braking distance included, stays clear of every place an echo may be from.
  double free_speed(const Observation& observation, double v, double w) const {
    constexpr int kTries = 8;
    for (int k = kTries; k > 0; --k) {
      const double candidate = v * k / kTries;
      if (clear(observation, candidate, w)) return candidate;
    }
    return 0;
  }

  /// One period under the command, then braking: is all of it free? Long braking is looked at less often, but at least
  /// once per radius of the way, and only so far: the echoes are nearer than its end then.
  bool clear(const Observation& observation, double v, double w) const {
    constexpr int kParts = 4, kBrakingParts = 512;
    const Body& body = platform_.body;
    double dt = observation.period / kParts;
    Pose2 pose;
    double v_now = observation.odometry.v, w_now = observation.odometry.w;
    for (int part = 0; part < kParts || (v_now > 0 && part < kParts + kBrakingParts); ++part) {
      const bool braking = part >= kParts;
      if (part == kParts) dt = std::max(dt, std::min(v_now / (body.a_v * kBrakingParts), body.radius / v_now));
      const Ramped v_next = ramped(v_now, braking ? 0 : v, body.a_v, dt);
      const Ramped w_next = ramped(w_now, braking ? 0 : w, body.a_w, dt);
      pose = arc(pose, v_next.mean, w_next.mean, dt);
      if (hits(pose.position(), options_.margin + options_.headway * v)) return false;
      v_now = v_next.end;
      w_now = w_next.end;
    }
    return true;
  }

  bool hits(const Vec2& center, double margin) const {
    const double least = platform_.body.radius + margin;
    for (const Echo& echo : echoes_)
      for (const Vec2& point : echo.places)
        if ((point - center).squaredNorm() < least * least && (point - center).squaredNorm() < point.squaredNorm())
          return true;
    return false;
  }

  static constexpr double kLeastGap = 0.01;  ///< the push is finite at contact [m]
  static constexpr double kMostPush = 3;     ///< times the pull

  Platform platform_;
  PotentialFieldOptions options_;
  std::vector<Echo> echoes_;
  Vec2 goal_{std::numeric_limits<double>::quiet_NaN(), 0};
  double nearest_ = 0;
  double since_ = 0;
};

}  // namespace

Navigator potential_field(const Platform& platform, const PotentialFieldOptions& options) {
  need_sonars("potential_field", platform);
  validate(options);
  auto field = std::make_shared<PotentialField>(platform, options);
  return {.name = "potential_field",
          .step = [field](const Observation& o, const Subgoal& s) { return field->step(o, s); },
          .reset = [field] { field->reset(); },
          .body_radius = platform.body.radius};
}

}  // namespace meander
