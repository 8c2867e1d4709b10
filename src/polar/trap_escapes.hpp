// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "polar/boundary_escape.hpp"
#include "polar/trap_watch.hpp"
#include "robot/observation.hpp"

namespace meander {

struct TrapOptions {
  bool watch = true;
  double patience = 15;
  double progress = 0.10;
  int escapes = 4;
  BoundaryEscapeOptions escape;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TrapOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"watch", "", "notice being trapped"}, o.watch);
  visit(Field{"patience", "s", "trapped after so long without progress", 0.1, 1e6}, o.patience);
  visit(Field{"progress", "m", "what counts as progress towards the subgoal", 0, 100}, o.progress);
  visit(Field{"escapes", "", "tries to get out along the wall, on one side and the other, before the guide is told", 0,
              1000},
        o.escapes);
  visit(Field{"escape", "", "along the wall"}, o.escape);
}

/// What to do about traps: escapes on one side and the other, then the guide must decide.
class TrapEscapes {
 public:
  TrapEscapes(const Platform& platform, const TrapOptions& options);

  struct Verdict {
    bool give_up = false;
    std::string reason;  ///< of giving up, or of a new escape; empty: nothing new
  };
  /// Once per cycle. `left`: the last subgoal was on the left of the way to the target.
  Verdict update(const Observation& observation, const Vec2& target, const SonarMemory& memory, bool left);
  /// Where to go instead of the target, while escaping.
  std::optional<Vec2> temporary() const;
  int traps() const { return watch_.traps(); }
  void reset();

 private:
  Verdict next(const Observation& observation, const Vec2& target, const std::string& why, bool left);
  Verdict go_on(const Observation& observation, const Vec2& target, const SonarMemory& memory);

  TrapOptions options_;
  TrapWatch watch_;
  BoundaryEscape escape_;
  std::optional<Vec2> target_;
  bool to_the_left_ = false;
  int escapes_ = 0;  ///< tried since there was progress
};

}  // namespace meander
