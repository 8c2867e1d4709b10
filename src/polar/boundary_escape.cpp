// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/boundary_escape.hpp"

#include "polar/near_points.hpp"

namespace meander {
namespace {

constexpr double kAhead = 1.2;     ///< distance of temporary targets at most [m]
constexpr double kAnywhere = 0.3;  ///< what counts as another place [m]
constexpr double kLeast = 1.0;     ///< before it has gone so far, what is in reach is what did not help before [m]

}  // namespace

BoundaryEscape::BoundaryEscape(const Platform& platform, const BoundaryEscapeOptions& options)
    : body_radius_(platform.body.radius), options_(options), ways_(options.directions, options.reach) {}

void BoundaryEscape::begin(double time, const Pose2& pose, const Vec2& target, double nearest, bool left) {
  const Vec2 way = target - pose.position();
  const double side = left ? -1 : 1;
  walk_.emplace(side, angle_of(way.y(), way.x()) - side * kPi / 2, nearest, pose.position());
  place_ = pose.position();
  since_ = time;
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
  const bool under_way = walk_->driven() > kLeast;
  if (!under_way) walk_->begin_here();
  if (under_way && walk_->over(options_.leave)) return State::over;
  if (walk_->came_round(options_.loop)) return State::round;
  if ((pose.position() - place_).norm() > kAnywhere) place_ = pose.position(), since_ = time;
  return time - since_ > patience ? State::stuck : State::walking;
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
