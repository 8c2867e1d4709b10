// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/live_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/draw_parts.hpp"
#include "render/draw_world.hpp"

namespace meander {
namespace {

constexpr Background kBackground = Background::light;
constexpr Pose2 kGap{std::numeric_limits<double>::quiet_NaN(), 0, 0};

Vec2 between(const Vec2& from, const Vec2& to, double share) { return from + share * (to - from); }

Pose2 between(const Pose2& from, const Pose2& to, double share) {
  const Vec2 at = between(from.position(), to.position(), share);
  return {at.x(), at.y(), wrap_angle(from.heading + share * angle_between(from.heading, to.heading))};
}

}  // namespace

Moment between(const Moment& from, const Moment& to, double share) {
  if (from.poses.size() != to.poses.size() || from.movers.size() != to.movers.size()) return to;
  Moment moment = from;
  moment.time += share * (to.time - from.time);
  for (std::size_t k = 0; k < moment.poses.size(); ++k) moment.poses[k] = between(from.poses[k], to.poses[k], share);
  for (std::size_t k = 0; k < moment.movers.size(); ++k)
    moment.movers[k].center = between(from.movers[k].center, to.movers[k].center, share);
  return moment;
}

LivePicture::LivePicture(const World& world, std::vector<RobotLook> robots)
    : robots_(std::move(robots)), ways_(robots_.size()) {
  draw_ground(world);
}

void LivePicture::follow(const World& world) {
  if (world.revision() != seen_) draw_ground(world);
}

void LivePicture::draw_ground(const World& world) {
  WorldLook look;
  look.background = kBackground;
  look.movers = false;
  list_ = draw_world(world, look);
  ground_ = list_.items.size();
  seen_ = world.revision();
}

void LivePicture::set_goals(std::size_t robot, std::vector<TrackGoal> goals) {
  ways_.at(robot).goals = std::move(goals);
}

void LivePicture::pass(std::size_t robot, const Pose2& pose, bool touching) {
  Way& way = ways_.at(robot);
  extend(way, pose);
  if (touching && !way.touching) way.contacts.push_back(pose.position());
  way.touching = touching;
}

/// Places where the robot has been before are not drawn again: however long it drives, there is a limit to its way.
void LivePicture::extend(Way& way, const Pose2& pose) const {
  const double place = picture_unit(list_.view);  // a pixel of a terminal with a hundred columns
  if (way.last && (pose.position() - way.last->position()).norm() < 0.25 * place) return;
  const bool known = !way.places.emplace(std::lround(pose.x / place), std::lround(pose.y / place)).second;
  if (!known && way.known) {
    way.poses.push_back(kGap);
    way.poses.push_back(*way.last);
  }
  if (!known || !way.known) way.poses.push_back(pose);
  way.known = known;
  way.last = pose;
}

const DrawList& LivePicture::at(const Moment& moment) {
  const Theme& colors = theme(kBackground);
  list_.items.erase(list_.items.begin() + static_cast<std::ptrdiff_t>(ground_), list_.items.end());
  if (on_ground) on_ground(list_, colors);
  for (const Disc& mover : moment.movers) list_.items.push_back(DrawDisc{mover, colors.mover, Mark::mover});
  for (std::size_t k = 0; k < std::min(robots_.size(), moment.poses.size()); ++k) {
    // The scan stays where it was taken: that is the truth, and little of the picture changes between two scans.
    if (k < moment.ranges.size()) draw_scan(list_, robots_[k], moment.scanned_from[k], moment.ranges[k], colors);
    Way& way = ways_[k];
    const std::size_t length = way.poses.size();
    if (way.known) way.poses.push_back(kGap);
    way.poses.push_back(moment.poses[k]);
    draw_track(list_, {way.poses, robots_[k].radius, way.goals, way.contacts}, colors);
    way.poses.resize(length);
  }
  return list_;
}

}  // namespace meander
