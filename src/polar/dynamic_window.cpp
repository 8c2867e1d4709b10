// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/dynamic_window.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "polar/echo.hpp"
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

/// A turning rate of the window with the shape of its way: the cycle, then braking.
struct Turn {
  double w;
  double turned;      ///< until it stands again [rad]
  Vec2 drive, brake;  ///< where a way of length 1 leads
  SinCos heading;     ///< in the end
};

class DynamicWindow {
 public:
  DynamicWindow(const Platform& platform, const DynamicWindowOptions& options)
      : platform_(platform),
        options_(options),
        memory_(platform, options.memory),
        cones_(platform, options.memory.range_min, options.half_cone),
        trap_(options.patience, options.progress),
        radius_(platform.body.radius + options.margin),
        turns_(static_cast<std::size_t>(options.turns)) {}

  void reset() { *this = DynamicWindow(platform_, options_); }

  NavigatorStep step(const Observation& observation, const Subgoal& subgoal) {
    const Pose2& pose = observation.odometry.pose;
    memory_.remember(observation.readings);
    if (const auto there = arrival(observation, subgoal, platform_.body)) return *there;
    look(observation);
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
  /// The nearest first: they shorten the ways, and what is behind them need not be looked at then.
  void look(const Observation& observation) {
    const double reach = options_.reach + radius_;
    points_near(memory_, observation.odometry.pose, platform_.body.radius, reach, points_);
    cones_.add(observation, reach, points_);
    std::sort(points_.begin(), points_.end(), [](const Vec2& a, const Vec2& b) {
      const double one = a.squaredNorm(), other = b.squaredNorm();
      return one != other ? one < other : a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
  }

  /// [FBT97] 4.1: the dynamic window. Fast ones first: most of the slower ones cannot be better then, whatever way is
  /// free.
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
    // [FBT97+] A command takes effect when the cycle is over: until then the robot goes on as it does.
    const double before = observation.odometry.v * observation.period;
    for (int k = 0; k < options_.turns; ++k)
      turns_[static_cast<std::size_t>(k)] =
          turn(w_least + (w_most - w_least) * k / (options_.turns - 1), observation.period);
    for (int i = options_.speeds - 1; i >= 0; --i) {
      const double v = v_least + (v_most - v_least) * i / (options_.speeds - 1);
      const double driven = v * observation.period, braked = v * v / (2 * body.a_v);
      for (const Turn& turn : turns_) {
        const double worth = options_.heading_weight * heading(task, driven * turn.drive + braked * turn.brake, turn) +
                             options_.speed_weight * v / body.v_max;
        if (found && worth + options_.distance_weight <= most) continue;
        const double free = v > kStanding ? free_arc(points_, turn.w / v, radius_, options_.reach) : free_after(turn);
        // [FBT97] eq. (3): it must be able to stop in time.
        if (v > kStanding && free < before + driven + braked) continue;
        moves |= v > kStanding;
        const double all = worth + options_.distance_weight * free / options_.reach;
        if (!found || all > most) found = Command{v, turn.w, 0}, most = all;
      }
    }
    if (moves) {
      away_ = 0;
      return *found;
    }
    return observation.odometry.v > kStanding ? brake(observation) : turn_away(observation, task);
  }

  Turn turn(double w, double period) const {
    const double driven = w * period, braked = w * std::abs(w) / (2 * platform_.body.a_w);
    return {w, driven + braked, arc({}, 1, driven, 1).position(), arc({0, 0, driven}, 1, braked, 1).position(),
            sin_cos(driven + braked)};
  }

  /// [FBT97] eq. (6): how well the subgoal is faced in the end.
  static double heading(const Task& task, const Vec2& end, const Turn& turn) {
    const Vec2 way = task.subgoal - end;
    const double ahead = way.x() * turn.heading.cos + way.y() * turn.heading.sin;
    const double aside = way.y() * turn.heading.cos - way.x() * turn.heading.sin;
    return 1 - std::abs(angle_of(aside, ahead)) / kPi;
  }

  /// [FBT97+] A turn on the spot has the free way of the heading in which it ends: else standing would be the safest.
  double free_after(const Turn& turn) {
    turned_.clear();
    const Pose2 back{0, 0, -turn.turned};
    for (const Vec2& point : points_) turned_.push_back(back * point);
    return free_arc(turned_, 0, radius_, options_.reach);
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

  /// [FBT97+] It stands before it turns away, and brakes along the arc of the window that is free the longest: the one
  /// that it is on may just have turned out not to be.
  Command brake(const Observation& observation) {
    const double v = observation.odometry.v;
    double w = observation.odometry.w, most = -1;
    for (const Turn& turn : turns_) {
      const double free = free_arc(points_, turn.w / v, radius_, options_.reach);
      if (free > most) w = turn.w, most = free;
    }
    return {std::max(0.0, v - platform_.body.a_v * observation.period), w, 0};
  }

  static constexpr double kStanding = 0.01;  ///< slower counts as a turn on the spot [m/s]
  static constexpr double kTurnAway = 0.7;   ///< share of the largest turning rate

  Platform platform_;
  DynamicWindowOptions options_;
  SonarMemory memory_;
  ConeEnds cones_;
  TrapWatch trap_;
  double radius_;  ///< what counts as contact [m]
  std::vector<Turn> turns_;
  std::vector<Vec2> points_;
  std::vector<Vec2> turned_;  ///< room for points_ in another heading
  int away_ = 0;              ///< side to which it turns away; 0: it does not
};

}  // namespace

Navigator dynamic_window(const Platform& platform, const DynamicWindowOptions& options) {
  need_sonars("dynamic_window", platform);
  validate(options);
  auto window = std::make_shared<DynamicWindow>(platform, options);
  return {.name = "dynamic_window",
          .step = [window](const Observation& o, const Subgoal& s) { return window->step(o, s); },
          .reset = [window] { window->reset(); },
          .body_radius = platform.body.radius};
}

}  // namespace meander
