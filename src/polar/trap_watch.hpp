// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "base/fields.hpp"
#include "geometry/pose.hpp"

namespace meander {

struct TrapOptions {
  bool watch = true;
  double patience = 15;
  double progress = 0.10;
  int escapes = 3;
  double escape_time = 8;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TrapOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"watch", "", "notice being trapped"}, o.watch);
  visit(Field{"patience", "s", "trapped after so long without progress", 0.1, 1e6}, o.patience);
  visit(Field{"progress", "m", "what counts as progress towards the subgoal", 0, 100}, o.progress);
  visit(Field{"escapes", "", "tries to get out by a temporary target, before the guide is told", 0, 1000}, o.escapes);
  visit(Field{"escape_time", "s", "how long a temporary target holds; half as long again for those to the rear", 0.1,
              1e6},
        o.escape_time);
}

/// Notices that the robot gets no nearer, and sends it aside for a while.
class TrapWatch {
 public:
  explicit TrapWatch(const TrapOptions& options) : options_(options) {}

  enum class Event { none, escape, give_up };
  /// Once per cycle. `left`: the last subgoal was on the left of the way to the target.
  Event update(double time, const Vec2& at, const Vec2& target, bool left);
  /// Where to go instead of the target, while escaping.
  const std::optional<Vec2>& temporary() const { return temporary_; }
  int traps() const { return traps_; }      ///< noticed so far
  int escapes() const { return escapes_; }  ///< tried since there was progress
  double distance() const { return distance_; }
  void reset() { *this = TrapWatch(options_); }

 private:
  void begin(double time);
  Event trapped(double time, const Vec2& at, const Vec2& target, bool left);

  TrapOptions options_;
  std::optional<Vec2> target_;
  std::optional<Vec2> temporary_;
  double until_ = 0;
  double distance_ = 0;
  double nearest_ = 0;       ///< since the last new beginning [m]
  double nearest_ever_ = 0;  ///< to this target [m]
  double since_ = 0;
  bool to_the_left_ = false;
  int escapes_ = 0;
  int traps_ = 0;
};

}  // namespace meander
