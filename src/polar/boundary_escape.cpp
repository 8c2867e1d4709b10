// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/boundary_escape.hpp"

#include <algorithm>
#include <cmath>

#include "polar/near_points.hpp"

namespace meander {
namespace {

constexpr double kAhead = 1.2;     ///< distance of temporary targets at most [m]
constexpr double kAnywhere = 0.3;  ///< what counts as another place [m]
constexpr double kApart = 0.25;    ///< between places that are remembered [m]
constexpr double kAlike = 0.8;     ///< headings so near are the same direction along a wall [rad]
constexpr double kRound = 4.0;     ///< a way round is at least so long [m]
constexpr double kAgain = 1.5;     ///< way along places passed before that is no chance meeting, as at a door [m]
constexpr std::size_t kMostPassed = 512;

}  // namespace

BoundaryEscape::BoundaryEscape(const Platform& platform, const BoundaryEscapeOptions& options)
    : body_radius_(platform.body.radius), options_(options), ways_(options.directions, options.reach) {
  passed_.reserve(kMostPassed);
}

void BoundaryEscape::begin(double time, const Pose2& pose, const Vec2& target, double nearest, bool left,
                           double least) {
  const Vec2 way = target - pose.position();
  const double side = left ? -1 : 1;
  walk_.emplace(side, angle_of(way.y(), way.x()) - side * kPi / 2, nearest, pose.position());
  place_ = pose.position();
  since_ = time;
  least_ = least;
  new_until_ = 0;
  passed_.clear();
}

BoundaryEscape::State BoundaryEscape::update(double time, const Pose2& pose, const Vec2& target,
                                             const SonarMemory& memory, double patience) {
  const Vec2 goal = inverse(pose) * target;
  const double radius = body_radius_ + options_.clearance;
  points_near(memory, pose, body_radius_, options_.reach + radius, points_);
  ways_.look(points_, radius, angle_of(goal.y(), goal.x()));
  walk_->advance(pose, target, ways_, points_);
  const State state = judge(time, pose, patience);
  if (state == State::walking)
    choose(pose);
  else
    stop();
  return state;
}

BoundaryEscape::State BoundaryEscape::judge(double time, const Pose2& pose, double patience) {
  if (walk_->driven() > least_ && walk_->over(options_.leave)) return State::over;
  if (!passed_before(pose)) new_until_ = walk_->driven();
  if (walk_->driven() - new_until_ > kAgain) return State::round;
  remember(pose);
  if ((pose.position() - place_).norm() > kAnywhere) place_ = pose.position(), since_ = time;
  return time - since_ > patience ? State::stuck : State::walking;
}

/// The same place in the same direction along the same wall: so it would go on for ever.
bool BoundaryEscape::passed_before(const Pose2& pose) const {
  return std::any_of(passed_.begin(), passed_.end(), [&](const Passed& then) {
    return walk_->driven() - then.driven > kRound && (pose.position() - then.pose.position()).norm() < options_.loop &&
           std::abs(angle_between(pose.heading, then.pose.heading)) < kAlike;
  });
}

void BoundaryEscape::remember(const Pose2& pose) {
  const double driven = walk_->driven();
  if (passed_.size() == kMostPassed || (!passed_.empty() && driven - passed_.back().driven < kApart)) return;
  passed_.push_back({pose, driven});
}

/// Along the wall; where nothing is free far enough, the way that is free the farthest.
void BoundaryEscape::choose(const Pose2& pose) {
  int k = 0;
  if (const auto along = walk_->direction(pose, ways_, points_, options_.look)) {
    k = *along;
  } else {
    for (int i = 1; i < ways_.count(); ++i)
      if (ways_.way(i) > ways_.way(k)) k = i;
  }
  temporary_ = pose * ways_.place(k, std::min(kAhead, ways_.way(k)));
}

}  // namespace meander
