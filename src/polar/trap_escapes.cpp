// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/trap_escapes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meander {
namespace {

/// Before it has gone so far, what is in reach is what did not help before [m]; twice as far at each further try.
constexpr double kLeast = 1.0;

}  // namespace

TrapEscapes::TrapEscapes(const Platform& platform, const TrapOptions& options)
    : options_(options), watch_(options.patience, options.progress), escape_(platform, options.escape) {}

void TrapEscapes::reset() {
  watch_.reset();
  escape_.stop();
  target_.reset();
  escapes_ = 0;
}

std::optional<Vec2> TrapEscapes::temporary() const {
  return escape_.active() ? std::optional(escape_.temporary()) : std::nullopt;
}

TrapEscapes::Verdict TrapEscapes::update(const Observation& observation, const Vec2& target, const SonarMemory& memory,
                                         bool left) {
  if (!options_.watch) return {};
  if (target_ != target) escape_.stop();
  target_ = target;
  const Vec2 at = observation.odometry.pose.position();
  if (escape_.active()) watch_.begin(observation.time);
  const bool trapped = watch_.update(observation.time, at, target);
  if (watch_.new_nearest()) escapes_ = 0;
  Verdict verdict;
  if (trapped)
    verdict = next(observation, target, fmt::format("no progress for {:g} s", options_.patience),
                   escapes_ == 0 ? left : !to_the_left_);
  if (!escape_.active()) return verdict;
  Verdict later = go_on(observation, target, memory);
  return later.reason.empty() ? verdict : later;
}

/// The next escape, if there are any left.
TrapEscapes::Verdict TrapEscapes::next(const Observation& observation, const Vec2& target, const std::string& why,
                                       bool left) {
  const std::string where = fmt::format("{}, {:.2f} m from the subgoal", why, watch_.distance());
  if (escapes_ >= options_.escapes) {
    escapes_ = 0;
    return {true, options_.escapes > 0 ? fmt::format("{}, after {} escapes", where, options_.escapes) : where};
  }
  to_the_left_ = left;
  ++escapes_;
  escape_.begin(observation.time, observation.odometry.pose, target, watch_.nearest(), left,
                kLeast * (1 << std::min(escapes_ - 1, 10)));
  return {false,
          fmt::format("{}: escape {} of {}, to the {}", where, escapes_, options_.escapes, left ? "left" : "right")};
}

TrapEscapes::Verdict TrapEscapes::go_on(const Observation& observation, const Vec2& target, const SonarMemory& memory) {
  using enum BoundaryEscape::State;
  switch (escape_.update(observation.time, observation.odometry.pose, target, memory, options_.patience)) {
    case over:
      watch_.begin(observation.time);
      return {};
    case round:
      return next(observation, target, "came round to where it has been", !to_the_left_);
    case stuck:
      return next(observation, target, fmt::format("no way on for {:g} s", options_.patience), !to_the_left_);
    case walking:
      break;
  }
  return {};
}

}  // namespace meander
