// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/tangent_bug.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "polar/near_points.hpp"

namespace meander {
namespace {

Vec2 along(double angle, double way) {
  const SinCos t = sin_cos(angle);
  return {way * t.cos, way * t.sin};
}

/// Walking along a wall.
struct Following {
  double side;        ///< 1: the wall is on the left
  double along;       ///< direction driven last, in the odometry frame [rad]
  double nearest;     ///< distance from the subgoal to the nearest place of it so far [m]
  Vec2 begin;         ///< where it began, in the odometry frame
  double driven = 0;  ///< since then [m]
};

class TangentBug {
 public:
  TangentBug(const Platform& platform, const TangentBugOptions& options)
      : platform_(platform),
        options_(options),
        memory_(platform, options.memory),
        steering_(platform, options.steering),
        step_(2 * kPi / options.directions),
        free_(static_cast<std::size_t>(options.directions)) {}

  void reset() { *this = TangentBug(platform_, options_); }

  NavigatorStep step(const Observation& observation, const Subgoal& subgoal) {
    const Pose2& pose = observation.odometry.pose;
    memory_.remember(observation.readings);
    if (subgoal.position != subgoal_) begin(observation, subgoal.position);
    if (const auto there = arrival(observation, subgoal, platform_.body)) return *there;
    look(pose);
    if (following_) follow();
    std::optional<double> bearing;
    if (!following_) bearing = past_the_ends();
    if (following_) bearing = along_the_wall();
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

  std::size_t at(int k) const {
    return static_cast<std::size_t>((k % options_.directions + options_.directions) % options_.directions);
  }
  /// Direction k, from the subgoal's on counter-clockwise, in the robot's frame.
  double bearing_of(int k) const { return wrap_angle(target_bearing_ + k * step_); }
  Vec2 place_at(int k, double way) const { return along(bearing_of(k), way); }

  /// [KRR98] the local tangent graph's range profile: the free way of the body in every direction.
  void look(const Pose2& pose) {
    before_ = here_;
    here_ = pose.position();
    heading_ = pose.heading;
    target_ = inverse(pose) * subgoal_;
    target_bearing_ = angle_of(target_.y(), target_.x());
    const double radius = platform_.body.radius + options_.clearance;
    points_near(memory_, pose, platform_.body.radius, options_.reach + radius, points_);
    std::fill(free_.begin(), free_.end(), options_.reach);
    for (const Vec2& point : points_) shorten(point, radius);
  }

  /// The directions in which the body would touch the point, and after which way.
  void shorten(const Vec2& point, double radius) {
    const double distance = point.norm(), touch = std::min(radius, distance - kContact);
    const double bearing = angle_between(target_bearing_, angle_of(point.y(), point.x()));
    const double half = angle_of(touch, std::sqrt(distance * distance - touch * touch));
    const int first = static_cast<int>(std::ceil((bearing - half) / step_));
    const int last = static_cast<int>(std::floor((bearing + half) / step_));
    for (int k = first; k <= last; ++k) {
      const SinCos off = sin_cos(k * step_ - bearing);
      const double beside = distance * off.sin;
      const double way = distance * off.cos - std::sqrt(std::max(0.0, touch * touch - beside * beside));
      free_[at(k)] = std::min(free_[at(k)], std::max(0.0, way));
    }
  }

  bool target_in_sight() const { return free_[0] >= std::min(target_.norm(), options_.reach) - kTouch; }

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
      const double beside = std::min(free_[at(k - 1)], free_[at(k + 1)]);
      if (free_[at(k)] - beside < options_.jump) continue;
      const Vec2 end = place_at(k, std::min(free_[at(k)], beside + options_.jump));
      const double rest = (target_ - end).norm();
      double way = end.norm() + rest;
      if (chosen_ && std::abs(angle_between(*chosen_, heading_ + bearing_of(k))) > kSameEnd) way += options_.constancy;
      if (!best || way < least) best = k, least = way;
      if (rest < target_.norm() && (!nearer || way < least_nearer)) nearer = k, least_nearer = way;
    }
    if (nearer) {
      chosen_ = heading_ + bearing_of(*nearer);
      return bearing_of(*nearer);
    }
    // The wall is to be on the side from which the end is reached: end on the left, wall on the right.
    const double end = best ? bearing_of(*best) - target_bearing_ : kPi;
    const double side = wrap_angle(end) >= 0 ? -1 : 1;
    following_ = Following{
        .side = side, .along = heading_ + target_bearing_ - side * kPi / 2, .nearest = target_.norm(), .begin = here_};
    return std::nullopt;
  }

  /// [KRR98] leave the boundary when a place is in reach that is nearer to the subgoal than all of it was.
  void follow() {
    Following& wall = *following_;
    wall.driven += (here_ - before_).norm();
    double reach = target_.norm();
    for (int k = 0; k < options_.directions; ++k) {
      const double way = std::clamp(target_.norm() * sin_cos(k * step_).cos, 0.0, free_[at(k)]);
      reach = std::min(reach, (target_ - place_at(k, way)).norm());
    }
    wall.nearest = std::min(wall.nearest, target_.norm());
    for (const Vec2& point : points_)
      if (point.norm() < std::min(kOwnWall, target_.norm()))
        wall.nearest = std::min(wall.nearest, (target_ - point).norm());
    if (reach < wall.nearest - options_.leave) following_.reset();
  }

  /// The first free direction, seen from the wall on. The wall is the nearest thing on its side of the way: across a
  /// narrow place another may be nearer.
  std::optional<double> along_the_wall() {
    Following& wall = *following_;
    const double beside = angle_between(heading_, wall.along + wall.side * kPi / 2);
    double from = beside, nearest = std::numeric_limits<double>::infinity();
    for (const Vec2& point : points_) {
      const double bearing = angle_of(point.y(), point.x());
      if (point.squaredNorm() >= nearest || std::abs(angle_between(beside, bearing)) > kBeside) continue;
      nearest = point.squaredNorm();
      from = bearing;
    }
    const auto first = static_cast<int>(std::floor(angle_between(target_bearing_, from) / step_ + 0.5));
    const int turn = wall.side > 0 ? -1 : 1;
    for (int i = 0; i < options_.directions; ++i) {
      const int k = first + turn * i;
      if (free_[at(k)] < options_.follow_look) continue;
      wall.along = heading_ + bearing_of(k);
      return bearing_of(k);
    }
    return std::nullopt;
  }

  Command drive(const std::optional<double>& bearing, const Observation& observation) const {
    if (!bearing) return steering_.turn(following_ && following_->side < 0 ? kPi / 2 : -kPi / 2, observation);
    return steering_.towards(*bearing, target_.norm(), observation, points_);
  }

  /// Why it cannot go on, or nothing. Then it forgets the wall and tries anew.
  std::string stuck(const Observation& observation) {
    if (following_ && following_->driven > kRound * options_.loop &&
        (here_ - following_->begin).norm() < options_.loop) {
      following_.reset();
      return "came round to where it met the obstacle";
    }
    if ((here_ - place_).norm() > options_.progress) place_ = here_, since_ = observation.time;
    if (observation.time - since_ <= options_.patience) return {};
    since_ = observation.time;
    following_.reset();
    return fmt::format("no way on for {:g} s", options_.patience);
  }

  static constexpr double kContact = 1e-3;  ///< points within the body count as touched from so far outside [m]
  static constexpr double kTouch = 1e-6;    ///< [m]
  static constexpr double kBeside = 1.9;    ///< how far from beside the way the wall may be [rad]
  static constexpr double kRound = 8;       ///< a way round is at least so many times the size of `loop`
  static constexpr double kOwnWall = 1.2;   ///< what is nearer belongs to the wall that is followed [m]
  static constexpr double kSameEnd = 0.35;  ///< directions nearer to each other are the same end [rad]

  Platform platform_;
  TangentBugOptions options_;
  SonarMemory memory_;
  Steering steering_;
  double step_;
  std::vector<double> free_;  ///< way [m] in each direction, the subgoal's first
  std::vector<Vec2> points_;
  Vec2 subgoal_{std::numeric_limits<double>::quiet_NaN(), 0};
  Vec2 target_{0, 0};  ///< the subgoal in the robot's frame
  double target_bearing_ = 0;
  Vec2 here_{0, 0};
  Vec2 before_{0, 0};  ///< a cycle ago
  double heading_ = 0;
  std::optional<double> chosen_;  ///< direction of the end chosen last, in the odometry frame
  std::optional<Following> following_;
  Vec2 place_{0, 0};  ///< where it was when it last got anywhere
  double since_ = 0;
};

}  // namespace

Navigator tangent_bug(const Platform& platform, const TangentBugOptions& options) {
  validate(platform);
  validate(options);
  auto bug = std::make_shared<TangentBug>(platform, options);
  return {.name = "tangent_bug",
          .step = [bug](const Observation& o, const Subgoal& s) { return bug->step(o, s); },
          .reset = [bug] { bug->reset(); }};
}

}  // namespace meander
