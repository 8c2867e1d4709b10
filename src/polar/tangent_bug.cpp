// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/tangent_bug.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "polar/boundary_walk.hpp"
#include "polar/echo.hpp"
#include "polar/near_points.hpp"

namespace meander {
namespace {

class TangentBug {
 public:
  TangentBug(const Platform& platform, const TangentBugOptions& options)
      : platform_(platform),
        options_(options),
        memory_(platform, options.memory),
        cones_(platform, options.memory.range_min, options.half_cone),
        steering_(platform, options.steering),
        ways_(options.directions, options.reach) {}

  void reset() { *this = TangentBug(platform_, options_); }

  NavigatorStep step(const Observation& observation, const Subgoal& subgoal) {
    const Pose2& pose = observation.odometry.pose;
    memory_.remember(observation.readings);
    if (subgoal.position != subgoal_) begin(observation, subgoal.position);
    if (const auto there = arrival(observation, subgoal, platform_.body)) return *there;
    look(observation);
    if (following_) follow(pose);
    std::optional<double> bearing;
    if (!following_) bearing = past_the_ends();
    if (following_) bearing = along_the_wall(pose);
    NavigatorStep step{drive(bearing, observation), NavigatorStatus::driving, {}};
    if (std::string why = stuck(observation); !why.empty()) {
      step.status = NavigatorStatus::trapped;
      step.reason = fmt::format("{}, {:.2f} m from the subgoal", why, target_.norm());
    }
    return step;
  }

 private:
  void begin(const Observation& observation, const Vec2& subgoal) {
    subgoal_ = subgoal;
    following_.reset();
    chosen_.reset();
    place_ = observation.odometry.pose.position();
    since_ = observation.time;
  }

  /// [KRR98] the local tangent graph's range profile: the free way of the body in every direction.
  void look(const Observation& observation) {
    const Pose2& pose = observation.odometry.pose;
    here_ = pose.position();
    heading_ = pose.heading;
    target_ = inverse(pose) * subgoal_;
    target_bearing_ = angle_of(target_.y(), target_.x());
    const double radius = platform_.body.radius + options_.clearance;
    // Steering looks as far as braking leads, however near the profile ends.
    const double farthest = std::max(options_.reach + radius, steering_.reach(observation));
    points_near(memory_, pose, platform_.body.radius, farthest, points_);
    cones_.add(observation, farthest, points_);
    ways_.look(points_, radius, target_bearing_);
  }

  bool target_in_sight() const { return ways_.way(0) >= std::min(target_.norm(), options_.reach) - kTouch; }

  /// [KRR98] motion to the goal: to the end of an obstacle over which the way is shortest. No end nearer to the subgoal
  /// than the robot is: it begins to follow the wall.
  std::optional<double> past_the_ends() {
    if (target_in_sight()) {
      chosen_.reset();
      return target_bearing_;
    }
    std::optional<int> best, nearer;
    double least = 0, least_nearer = 0;
    for (int k = 0; k < options_.directions; ++k) {
      const double beside = std::min(ways_.way(k - 1), ways_.way(k + 1));
      if (ways_.way(k) - beside < options_.jump) continue;
      const Vec2 end = ways_.place(k, std::min(ways_.way(k), beside + options_.jump));
      const double rest = (target_ - end).norm();
      double way = end.norm() + rest;
      if (chosen_ && std::abs(angle_between(*chosen_, heading_ + ways_.bearing(k))) > kSameEnd)
        way += options_.constancy;
      if (!best || way < least) best = k, least = way;
      if (rest < target_.norm() && (!nearer || way < least_nearer)) nearer = k, least_nearer = way;
    }
    if (nearer) {
      chosen_ = heading_ + ways_.bearing(*nearer);
      return ways_.bearing(*nearer);
    }
    // The wall is to be on the side from which the end is reached: end on the left, wall on the right.
    const double end = best ? ways_.bearing(*best) - target_bearing_ : kPi;
    const double side = wrap_angle(end) >= 0 ? -1 : 1;
    following_.emplace(side, heading_ + target_bearing_ - side * kPi / 2, target_.norm(), here_);
    return std::nullopt;
  }

  /// [KRR98] leave the boundary when a place is in reach that is nearer to the subgoal than all of it was.
  void follow(const Pose2& pose) {
    following_->advance(pose, subgoal_, ways_, points_);
    if (following_->over(options_.leave)) following_.reset();
  }

  std::optional<double> along_the_wall(const Pose2& pose) {
    const auto k = following_->direction(pose, ways_, points_, options_.follow_look);
    return k ? std::optional(ways_.bearing(*k)) : std::nullopt;
  }

  Command drive(const std::optional<double>& bearing, const Observation& observation) const {
    if (!bearing) return steering_.turn(following_ && following_->side() < 0 ? kPi / 2 : -kPi / 2, observation);
    return steering_.towards(*bearing, target_.norm(), observation, points_);
  }

  /// Why it cannot go on, or nothing. Then it forgets the wall and tries anew.
  std::string stuck(const Observation& observation) {
    if (following_ && following_->came_round(options_.loop)) {
      following_.reset();
      return "came round to where it met the obstacle";
    }
    if ((here_ - place_).norm() > options_.progress) place_ = here_, since_ = observation.time;
    if (observation.time - since_ <= options_.patience) return {};
    since_ = observation.time;
    following_.reset();
    return fmt::format("no way on for {:g} s", options_.patience);
  }

  static constexpr double kTouch = 1e-6;    ///< [m]
  static constexpr double kSameEnd = 0.35;  ///< directions nearer to each other are the same end [rad]

  Platform platform_;
  TangentBugOptions options_;
  SonarMemory memory_;
  ConeEnds cones_;
  Steering steering_;
  FreeWays ways_;  ///< the subgoal's direction first
  std::vector<Vec2> points_;
  Vec2 subgoal_{std::numeric_limits<double>::quiet_NaN(), 0};
  Vec2 target_{0, 0};  ///< the subgoal in the robot's frame
  double target_bearing_ = 0;
  Vec2 here_{0, 0};
  double heading_ = 0;
  std::optional<double> chosen_;  ///< direction of the end chosen last, in the odometry frame
  std::optional<BoundaryWalk> following_;
  Vec2 place_{0, 0};  ///< where it was when it last got anywhere
  double since_ = 0;
};

}  // namespace

Navigator tangent_bug(const Platform& platform, const TangentBugOptions& options) {
  need_sonars("tangent_bug", platform);
  validate(options);
  auto bug = std::make_shared<TangentBug>(platform, options);
  return {.name = "tangent_bug",
          .step = [bug](const Observation& o, const Subgoal& s) { return bug->step(o, s); },
          .reset = [bug] { bug->reset(); },
          .body_radius = platform.body.radius};
}

}  // namespace meander
