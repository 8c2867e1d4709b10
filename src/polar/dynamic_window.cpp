// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/dynamic_window.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "polar/near_points.hpp"
#include "polar/steering.hpp"
#include "robot/kinematics.hpp"

namespace meander {
namespace {

/// Where the subgoal is and how fast the robot may go for its sake.
struct Task {
  Vec2 subgoal;
  double most;
};

class DynamicWindow {
 public:
  DynamicWindow(const Platform& platform, const DynamicWindowOptions& options)
      : platform_(platform),
        options_(options),
        memory_(platform, options.memory),
        trap_(options.patience, options.progress) {}

  void reset() { *this = DynamicWindow(platform_, options_); }

  NavigatorStep step(const Observation& observation, const Subgoal& subgoal) {
    const Pose2& pose = observation.odometry.pose;
    memory_.remember(observation.readings);
    if (const auto there = arrival(observation, subgoal, platform_.body)) return *there;
    points_near(memory_, pose, platform_.body.radius, options_.reach + platform_.body.radius + options_.margin,
                points_);
    const Vec2 to_subgoal = inverse(pose) * subgoal.position;
    const double distance = to_subgoal.norm();
    const Task task{to_subgoal,
                    std::min(std::sqrt(2 * platform_.body.a_v * distance), distance / (2 * observation.period))};
    NavigatorStep step{best(observation, task), NavigatorStatus::driving, {}};
    if (trap_.update(observation.time, pose.position(), subgoal.position)) {
      step.status = NavigatorStatus::trapped;
      step.reason = fmt::format("no progress for {:g} s, {:.2f} m from the subgoal: no velocity is better",
                                options_.patience, distance);
    }
    return step;
  }

 private:
  /// [FBT97] 4.1: the dynamic window.
  Command best(const Observation& observation, const Task& task) {
    const Body& body = platform_.body;
    const double dv = body.a_v * observation.period, dw = body.a_w * observation.period;
    const double v_least = std::clamp(observation.odometry.v - dv, 0.0, body.v_max);
    const double v_most = std::max(v_least, std::min(observation.odometry.v + dv, std::min(body.v_max, task.most)));
    const double w_least = std::max(observation.odometry.w - dw, -body.w_max);
    const double w_most = std::min(observation.odometry.w + dw, body.w_max);
    std::optional<Command> found;
    double most = 0;
    bool moves = false;
    for (int i = 0; i < options_.speeds; ++i)
      for (int k = 0; k < options_.turns; ++k) {
        const double v = v_least + (v_most - v_least) * i / (options_.speeds - 1);
        const double w = w_least + (w_most - w_least) * k / (options_.turns - 1);
        const std::optional<double> worth = objective(observation, task, v, w);
        if (!worth) continue;
        moves |= v > kStanding;
        if (!found || *worth > most) found = Command{v, w, 0}, most = *worth;
      }
    if (moves) {
      away_ = 0;
      return *found;
    }
    return turn_away(observation, task);
  }

  /// [FBT97] eq. (6); nothing when the robot could not stop in time (eq. (3)).
  /// [FBT97+] A turn on the spot has the free way of the heading in which it ends: else standing would be the safest.
  std::optional<double> objective(const Observation& observation, const Task& task, double v, double w) const {
    const Body& body = platform_.body;
    const double dt = observation.period, radius = body.radius + options_.margin;
    const double need = v * dt + v * v / (2 * body.a_v);
    const double turned = w * dt + w * std::abs(w) / (2 * body.a_w);
    double free;
    if (v > kStanding) {
      free = free_arc(points_, w / v, radius, options_.reach);
      if (free < need) return std::nullopt;
    } else {
      turned_.clear();
      const Pose2 back{0, 0, -turned};
      for (const Vec2& point : points_) turned_.push_back(back * point);
      free = free_arc(turned_, 0, radius, options_.reach);
    }
    const Pose2 end = arc(arc({}, v, w, dt), need - v * dt, turned - w * dt, 1);
    const Vec2 way = inverse(end) * task.subgoal;
    const double heading = 1 - std::abs(angle_of(way.y(), way.x())) / kPi;
    return options_.heading_weight * heading + options_.distance_weight * free / options_.reach +
           options_.speed_weight * v / body.v_max;
  }

  /// [FBT97] 4.2: where no translation is admissible, rotate until one is. It goes on in the direction begun.
  Command turn_away(const Observation& observation, const Task& task) {
    const Body& body = platform_.body;
    if (away_ == 0) {
      const double left = free_arc(points_, 1 / body.radius, body.radius, options_.reach);
      const double right = free_arc(points_, -1 / body.radius, body.radius, options_.reach);
      away_ = left != right ? (left > right ? 1 : -1) : (task.subgoal.y() < 0 ? -1 : 1);
    }
    const double w = away_ * kTurnAway * body.w_max;
    const double dw = body.a_w * observation.period;
    return {0, std::clamp(w, observation.odometry.w - dw, observation.odometry.w + dw), 0};
  }

  static constexpr double kStanding = 0.01;  ///< slower counts as a turn on the spot [m/s]
  static constexpr double kTurnAway = 0.7;   ///< share of the largest turning rate

  Platform platform_;
  DynamicWindowOptions options_;
  SonarMemory memory_;
  TrapWatch trap_;
  std::vector<Vec2> points_;
  mutable std::vector<Vec2> turned_;  ///< room for points_ in another heading
  int away_ = 0;                      ///< side to which it turns away; 0: it does not
};

}  // namespace

Navigator dynamic_window(const Platform& platform, const DynamicWindowOptions& options) {
  validate(platform);
  validate(options);
  auto window = std::make_shared<DynamicWindow>(platform, options);
  return {.name = "dynamic_window",
          .step = [window](const Observation& o, const Subgoal& s) { return window->step(o, s); },
          .reset = [window] { window->reset(); }};
}

}  // namespace meander
