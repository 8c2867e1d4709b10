// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "base/fields.hpp"
#include "robot/observation.hpp"

namespace meander {

/// Where to go next, in the odometry frame.
struct Subgoal {
  Vec2 position{0, 0};
  double tolerance = 0.25;          ///< arrived when the robot's centre is this near [m]
  std::optional<double> heading{};  ///< wanted on arrival [rad]; none: any
  std::string name{};               ///< for people; may be empty
};

enum class NavigatorStatus { driving, arrived, trapped };
template <>
struct EnumNames<NavigatorStatus> {
  static constexpr std::pair<NavigatorStatus, const char*> entries[] = {{NavigatorStatus::driving, "driving"},
                                                                        {NavigatorStatus::arrived, "arrived"},
                                                                        {NavigatorStatus::trapped, "trapped"}};
};

struct NavigatorStep {
  Command command;
  NavigatorStatus status = NavigatorStatus::driving;
  std::string reason{};  ///< why trapped, in words
};

/// Drives towards one subgoal by readings and odometry alone.
struct Navigator {
  std::string name;
  std::function<NavigatorStep(const Observation&, const Subgoal&)> step;
  std::function<void()> reset = [] {};  ///< forget everything: a new run begins
  double body_radius = 0;               ///< of the robot that it is made for [m]; 0: any
};
/// Throws ArgumentError when the navigator is made for a robot of another size.
void check_body(const Navigator& navigator, double radius);

struct GuideStep {
  std::optional<Subgoal> subgoal;  ///< none: finished
  bool success = false;            ///< when finished: was the task done?
  std::string reason;              ///< when finished: why, in words
  int reached = 0;                 ///< subgoals reached so far
};

/// Says where to go. Called once per control cycle, before the navigator, with the navigator's last step.
struct Guide {
  std::string name;
  std::function<GuideStep(const Observation&, const NavigatorStep&)> next;
  std::function<void()> reset = [] {};
  int subgoals = 0;  ///< how many there are in all, 0 when unknown
};

}  // namespace meander
