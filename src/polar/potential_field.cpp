// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/potential_field.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "robot/kinematics.hpp"

namespace meander {
namespace {

/// Where an echo may have come from, in the robot's present frame.
struct Echo {
  Vec2 point;               ///< on the axis of the cone
  std::array<Vec2, 3> arc;  ///< left rim, axis, right rim
  double gap;               ///< from the hull [m]
};

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
    look(observation);
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

  void look(const Observation& observation) {
    echoes_.clear();
    const RingLayout& ring = platform_.sonar;
    const Pose2 robot_from_odometry = inverse(observation.odometry.pose);
    const Readings& readings = observation.readings;
    for (std::size_t i = 0; i < readings.sonar.size(); ++i) {
      if (readings.sonar[i] > kSeen) continue;
      const Pose2 then = robot_from_odometry * readings.sonar_pose[i];
      const double bearing = ring.first + 2 * std::numbers::pi * static_cast<double>(i) / ring.count;
      const Vec2 sonar = then * polar_point(ring.radius, bearing);
      const auto at = [&](double offset) {
        return Vec2(sonar + polar_point(readings.sonar[i], then.heading + bearing + offset));
      };
      const Vec2 axis = at(0);
      echoes_.push_back({axis,
                         {at(options_.half_cone), axis, at(-options_.half_cone)},
                         std::max(axis.norm() - platform_.body.radius, 0.0)});
    }
  }

  Vec2 pull(const Vec2& to_subgoal, double distance) const {
    return to_subgoal * (options_.attraction / std::max(distance, options_.attraction_reach));
  }

  /// [K86] eq. (20): eta (1/rho - 1/rho_0) / rho^2 away from each surface nearer than rho_0.
  Vec2 push() const {
    Vec2 force{0, 0};
    for (const Echo& echo : echoes_) {
      const double rho = std::max(echo.gap, kLeastGap);
      if (rho >= options_.influence) continue;
      const double size = options_.repulsion * (1 / rho - 1 / options_.influence) / (rho * rho);
      force -= std::min(size, kMostPush) * echo.point.normalized();
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
    double gap = kSeen;
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

  bool clear(const Observation& observation, double v, double w) const {
    constexpr double kSpacing = 0.05;  // [m]
    const double start = observation.odometry.v;
    const double way = std::max(v, start) * observation.period + v * v / (2 * platform_.body.a_v);
    const int samples = static_cast<int>(std::ceil(way / kSpacing));
    const double time = v > 0 ? way / v : 0;
    for (int i = 1; i <= samples; ++i)
      if (hits(arc({}, v, w, time * i / samples).position())) return false;
    return true;
  }

  bool hits(const Vec2& center) const {
    const double least = platform_.body.radius + options_.margin;
    for (const Echo& echo : echoes_)
      for (const Vec2& point : echo.arc)
        if ((point - center).squaredNorm() < least * least && (point - center).squaredNorm() < point.squaredNorm())
          return true;
    return false;
  }

  static Vec2 polar_point(double radius, double angle) {
    const SinCos t = sin_cos(angle);
    return {radius * t.cos, radius * t.sin};
  }

  static constexpr double kSeen = 3;         ///< farther echoes do not matter [m]
  static constexpr double kLeastGap = 0.02;  ///< the push is finite at contact [m]
  static constexpr double kMostPush = 50;

  Platform platform_;
  PotentialFieldOptions options_;
  std::vector<Echo> echoes_;
  Vec2 goal_{std::numeric_limits<double>::quiet_NaN(), 0};
  double nearest_ = 0;
  double since_ = 0;
};

}  // namespace

Navigator potential_field(const Platform& platform, const PotentialFieldOptions& options) {
  validate(platform);
  validate(options);
  auto field = std::make_shared<PotentialField>(platform, options);
  return {.name = "potential_field",
          .step = [field](const Observation& o, const Subgoal& s) { return field->step(o, s); },
          .reset = [field] { field->reset(); }};
}

}  // namespace meander
