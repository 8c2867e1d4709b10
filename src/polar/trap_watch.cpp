// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/trap_watch.hpp"

namespace meander {

bool TrapWatch::update(double time, const Vec2& at, const Vec2& target) {
  distance_ = (target - at).norm();
  const bool other = target_ != target;
  new_nearest_ = other || distance_ < nearest_ever_ - progress_;
  if (new_nearest_) nearest_ever_ = distance_;
  if (other || distance_ < nearest_ - progress_) begin(time);
  target_ = target;
  if (time - since_ <= patience_) return false;
  ++traps_;
  begin(time);
  return true;
}

void TrapWatch::begin(double time) {
  nearest_ = distance_;
  since_ = time;
}

}  // namespace meander
