// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/subgoal_list.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace meander {
namespace {

std::string called(const std::vector<Subgoal>& subgoals, std::size_t index) {
  const Subgoal& subgoal = subgoals[index];
  const std::string at = fmt::format("({:.2f}, {:.2f})", subgoal.position.x(), subgoal.position.y());
  return subgoal.name.empty() ? fmt::format("subgoal {} at {}", index + 1, at)
                              : fmt::format("subgoal {} '{}' at {}", index + 1, subgoal.name, at);
}

void check(const std::vector<Subgoal>& subgoals) {
  if (subgoals.empty()) fail("at least one subgoal expected, got none");
  for (std::size_t i = 0; i < subgoals.size(); ++i) {
    const Subgoal& s = subgoals[i];
    if (!s.position.allFinite() || (s.heading && !std::isfinite(*s.heading)))
      fail("subgoal {}: finite numbers expected, got ({}, {})", i + 1, s.position.x(), s.position.y());
    if (!(s.tolerance > 0) || !std::isfinite(s.tolerance))
      fail("subgoal {}: tolerance: a number > 0 [m] expected, got {}", i + 1, s.tolerance);
  }
}

class SubgoalList {
 public:
  SubgoalList(std::vector<Subgoal> subgoals, const SubgoalListOptions& options)
      : subgoals_(std::move(subgoals)), options_(options) {}

  GuideStep next(const Observation& observation, const NavigatorStep& navigator) {
    const Vec2 at = observation.odometry.pose.position();
    // The navigator's word is about the subgoal of the last cycle; it counts once.
    NavigatorStatus told = asked_ ? navigator.status : NavigatorStatus::driving;
    while (now_ < subgoals_.size()) {
      if (told == NavigatorStatus::arrived || near(at)) {
        ++reached_;
      } else if (told == NavigatorStatus::trapped && options_.when_trapped != WhenTrapped::insist) {
        if (options_.when_trapped == WhenTrapped::stop) return finished(trapped(navigator.reason));
        skipped_ = trapped(navigator.reason);
      } else {
        asked_ = true;
        return {.subgoal = subgoals_[now_], .success = false, .reason = {}, .reached = reached_};
      }
      ++now_;
      told = NavigatorStatus::driving;
    }
    if (reached_ == static_cast<int>(subgoals_.size())) return finished("all subgoals reached", true);
    return finished(fmt::format("{} of {} subgoals reached; {}", reached_, subgoals_.size(), skipped_));
  }

  void reset() { *this = SubgoalList(std::move(subgoals_), options_); }

 private:
  bool near(const Vec2& at) const {
    const Subgoal& subgoal = subgoals_[now_];
    if (subgoal.heading && now_ + 1 == subgoals_.size()) return false;  // only the navigator knows
    const double early = now_ + 1 < subgoals_.size() ? options_.hand_over : 0;
    return (subgoal.position - at).norm() <= std::max(subgoal.tolerance, early);
  }
  std::string trapped(const std::string& why) const {
    return fmt::format("trapped on the way to {}{}{}", called(subgoals_, now_), why.empty() ? "" : ": ", why);
  }
  GuideStep finished(const std::string& reason, bool success = false) const {
    return {.subgoal = {}, .success = success, .reason = reason, .reached = reached_};
  }

  std::vector<Subgoal> subgoals_;
  SubgoalListOptions options_;
  std::size_t now_ = 0;
  int reached_ = 0;
  bool asked_ = false;
  std::string skipped_;
};

}  // namespace

Guide subgoal_list(std::vector<Subgoal> subgoals, const SubgoalListOptions& options) {
  check(subgoals);
  validate(options);
  const int count = static_cast<int>(subgoals.size());
  auto list = std::make_shared<SubgoalList>(std::move(subgoals), options);
  return {.name = "subgoals",
          .next = [list](const Observation& o, const NavigatorStep& n) { return list->next(o, n); },
          .reset = [list] { list->reset(); },
          .subgoals = count};
}

}  // namespace meander
