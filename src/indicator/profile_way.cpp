// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/profile_way.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace meander {
namespace {

constexpr double kTrail = 0.5;     ///< the way it came by begins so far back on the trail [m]
constexpr double kBehind = 0.9;    ///< an opening off that by less is the way it came by [rad]
constexpr double kLeave = 0.95;    ///< so far openings are those of the crossing just left [m]
constexpr double kStraight = 0.5;  ///< so far it keeps to the port's direction [m]
constexpr double kLook = 0.1;      ///< it looks for openings after so much way [m]
constexpr double kAhead = 0.8;     ///< subgoals are so far ahead at most [m]
constexpr double kAnchor = 0.75;   ///< the middle of a crossing is sought within this [m]
constexpr double kReject = 0.45;   ///< a crossing that was none: none is believed for so long [m]
constexpr double kThere = 0.1;     ///< [m]
constexpr double kApart = 0.55;    ///< crossings are so far from each other [m]
constexpr double kRound = 2;       ///< who comes back to a place after so much way went round [m]
constexpr int kTwice = 2;          ///< a crossing is to be seen so often
constexpr int kDeadEnds = 8;       ///< a dead end so often
constexpr int kAnchors = 3;        ///< better middles are sought so often
constexpr int kListen = 4;         ///< scans at the middle
constexpr int kPatience = 25;      ///< cycles on the way to a middle

}  // namespace

ProfileWay::ProfileWay(const Platform& platform, const SonarProfileOptions& options) : profile_(platform, options) {}

void ProfileWay::begin() {
  profile_.clear();
  trail_.clear();
  walked_ = left_at_ = looked_at_ = quiet_until_ = 0;
}

void ProfileWay::hear(const Observation& observation) {
  const Vec2 at = observation.odometry.pose.position();
  if (!trail_.empty()) walked_ += (at - at_).norm();
  at_ = at;
  if (trail_.empty() || walked_ - trail_.back().walked > kLook / 2) trail_.push_back({at, walked_});
  while (trail_.size() > 1 && walked_ - trail_[1].walked >= kTrail) trail_.pop_front();
  profile_.update(observation);
}

void ProfileWay::leave(double direction) {
  left_ = at_;
  left_at_ = looked_at_ = walked_;
  since_left_.assign(1, {at_, walked_});
  quiet_until_ = walked_ + kLeave;
  crossings_ = dead_ends_ = 0;
  to_anchor_ = false;
  drive_on(direction, kAhead);
}

std::optional<double> ProfileWay::back() const {
  if (trail_.empty() || walked_ - trail_.front().walked < kLook) return std::nullopt;
  const Vec2 way = trail_.front().at - at_;
  return way.norm() < kLook ? std::optional(wrap_angle(course_ + kPi)) : angle_of(way.y(), way.x());
}

/// The robot came by here, whatever the profile says: that way is open.
std::vector<SeenPort> ProfileWay::openings() {
  std::vector<SeenPort> seen = profile_.openings(at_);
  const auto from = back();
  if (!from) return seen;
  for (const SeenPort& port : seen)
    if (std::abs(angle_between(port.direction, *from)) < kBehind) return seen;
  seen.push_back({*from, kTrail});
  return seen;
}

std::vector<SeenPort> ProfileWay::ways_on() {
  std::vector<SeenPort> seen = openings();
  if (const auto from = back())
    std::erase_if(seen, [&](const SeenPort& port) { return std::abs(angle_between(port.direction, *from)) < kBehind; });
  return seen;
}

void ProfileWay::drive_on(double direction, double way) {
  course_ = direction;
  const SinCos to = sin_cos(direction);
  aim_ = at_ + std::min(way, kAhead) * Vec2(to.cos, to.sin);
}

ProfileWay::Found ProfileWay::follow() {
  if (to_anchor_) return at_anchor();
  if (walked() < kStraight || walked_ - looked_at_ < kLook) {
    const bool stuck = (aim_ - at_).norm() < kThere;
    if (!stuck) return Found::way;
  }
  looked_at_ = walked_;
  if (goes_round()) return Found::crossing;
  if (walked_ - since_left_.back().walked > kApart) since_left_.push_back({at_, walked_});
  return along();
}

/// It is back where it has been on this way: there was a crossing that it did not see, and without an indicator it
/// would go round for ever.
bool ProfileWay::goes_round() const {
  return std::any_of(since_left_.begin(), since_left_.end(), [&](const Step& step) {
    return walked_ - step.walked > kRound && (step.at - at_).norm() < kApart / 2;
  });
}

/// One way on: along it. More: there is a crossing about. None: to the end of the corridor.
ProfileWay::Found ProfileWay::along() {
  const std::vector<SeenPort> on = ways_on();
  crossings_ = on.size() > 1 && walked_ >= quiet_until_ ? crossings_ + 1 : 0;
  if (on.empty()) {
    const double left = profile_.way_on(at_, course_);
    if (left > 2 * kThere && dead_ends_ == 0) return drive_on(course_, left), Found::way;
    return ++dead_ends_ >= kDeadEnds ? Found::dead_end : Found::way;
  }
  dead_ends_ = 0;
  const SeenPort& next = *std::min_element(on.begin(), on.end(), [&](const SeenPort& a, const SeenPort& b) {
    return std::abs(angle_between(course_, a.direction)) < std::abs(angle_between(course_, b.direction));
  });
  drive_on(next.direction, next.reach);
  if (crossings_ < kTwice) return Found::way;
  to_anchor_ = true;
  anchors_ = 0;
  seek_anchor(kAnchor);
  return Found::way;
}

/// [DG+] Figure 3: motion directions are read at one place of the crossing only, where it is widest; how they look from
/// elsewhere does not count.
void ProfileWay::seek_anchor(double far) {
  constexpr int kRings = 5, kBearings = 16;
  Vec2 best = at_;
  double widest = profile_.clearance(at_);
  for (int ring = 1; ring <= kRings; ++ring)
    for (int i = 0; i < kBearings; ++i) {
      const double bearing = wrap_angle(2 * kPi * i / kBearings), away = far * ring / kRings;
      const SinCos to = sin_cos(bearing);
      const Vec2 there = at_ + away * Vec2(to.cos, to.sin);
      if ((there - left_).norm() < kApart || profile_.way_on(at_, bearing) < away) continue;
      const double wide = profile_.clearance(there);
      if (wide <= widest + 1e-9) continue;
      widest = wide;
      best = there;
    }
  aim_ = best;
  waited_ = listened_ = 0;
}

ProfileWay::Found ProfileWay::at_anchor() {
  ++waited_;
  if ((aim_ - at_).norm() > kThere && waited_ < kPatience) return Found::way;
  if (waited_ < kPatience && ++listened_ < kListen) return Found::way;
  if (++anchors_ < kAnchors) {
    seek_anchor(kAnchor / 3);
    if ((aim_ - at_).norm() > kThere) return Found::way;
  }
  to_anchor_ = false;
  const std::vector<SeenPort> on = ways_on();
  if (on.size() > 1) return Found::crossing;
  quiet_until_ = walked_ + kReject;
  crossings_ = 0;
  if (!on.empty()) drive_on(on.front().direction, on.front().reach);
  return Found::way;
}

}  // namespace meander
