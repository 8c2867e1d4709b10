// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/trap_watch.hpp"

namespace meander {
namespace {

constexpr double kAway = 6;         ///< distance of temporary targets [m]
constexpr double kToTheRear = 1.5;  ///< times as long
constexpr int kSidewards = 2;       ///< tries at +-90 degrees, then +-135

}  // namespace

TrapWatch::Event TrapWatch::update(double time, const Vec2& at, const Vec2& target, bool left) {
  if (!options_.watch) return Event::none;
  distance_ = (target - at).norm();
  if (target_ != target) {
    target_ = target;
    temporary_.reset();
    escapes_ = 0;
    nearest_ever_ = distance_;
    begin(time);
  }
  if (distance_ < nearest_ever_ - options_.progress) {
    nearest_ever_ = distance_;
    escapes_ = 0;
  }
  if (temporary_) {
    if (time < until_) return Event::none;
    temporary_.reset();
    begin(time);
  }
  if (distance_ < nearest_ - options_.progress) begin(time);
  return time - since_ > options_.patience ? trapped(time, at, target, left) : Event::none;
}

void TrapWatch::begin(double time) {
  nearest_ = distance_;
  since_ = time;
}

TrapWatch::Event TrapWatch::trapped(double time, const Vec2& at, const Vec2& target, bool left) {
  ++traps_;
  begin(time);
  if (escapes_ >= options_.escapes) {
    escapes_ = 0;
    return Event::give_up;
  }
  to_the_left_ = escapes_ == 0 ? left : !to_the_left_;
  const bool rear = escapes_ >= kSidewards;
  ++escapes_;
  const Vec2 way = target - at;
  const double turn = radians(rear ? 135 : 90) * (to_the_left_ ? 1 : -1);
  const Pose2 from{at.x(), at.y(), angle_of(way.y(), way.x()) + turn};
  temporary_ = from * Vec2(kAway, 0);
  until_ = time + options_.escape_time * (rear ? kToTheRear : 1);
  return Event::escape;
}

}  // namespace meander
