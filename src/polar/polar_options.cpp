// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_options.hpp"

#include <algorithm>

namespace meander {
namespace {

/// What somebody gave as well is no slip that may be passed over.
template <class T>
void turn(const char* name, T& option, const T& usual, T papers) {
  if (option != usual && option != papers)
    fail("option '{}': {} in mode 'paper' expected, got {}", name, papers, option);
  option = papers;
}

}  // namespace

PolarOptions in_mode(PolarOptions options) {
  if (options.mode == PolarMode::full) return options;
  const PolarOptions usual;
  turn("memory.contradictions", options.memory.contradictions, usual.memory.contradictions, 0);
  turn("subgoal.hysteresis", options.subgoal.hysteresis, usual.subgoal.hysteresis, 0.0);
  turn("trap.watch", options.trap.watch, usual.trap.watch, false);
  // The zone around obstacles costs, and more at any speed alike.
  turn("control.soft_margin", options.control.soft_margin, usual.control.soft_margin, 0.20);
  turn("control.soft_samples", options.control.soft_samples, usual.control.soft_samples, 0.8);
  turn("control.soft_speed_cost", options.control.soft_speed_cost, usual.control.soft_speed_cost, 0.0);
  return options;
}

namespace {

/// Floor that a map must show beyond the robot's slow zone [m].
constexpr double kSeen = 0.05;

void check_scope(const PolarOptions& o, const Body& body) {
  const double margin = std::max(o.map.margin, o.control.soft_margin), least = body.radius + margin + kSeen;
  if (!(o.map.layout.scope >= least))
    fail(
        "option 'map.scope': at least {:.4g} m expected (the robot's radius {} m, its margin {} m and {} m more), got "
        "{}",
        least, body.radius, margin, kSeen, o.map.layout.scope);
}

void check_order(const char* less, double a, const char* more, double b) {
  if (!(a <= b)) fail("option '{}': at most {} = {} m expected, got {}", less, more, b, a);
}

}  // namespace

void check(const PolarOptions& options, const Body& body) {
  validate(options);
  check_scope(options, body);
  check_order("map.narrow_margin", options.map.narrow_margin, "map.margin", options.map.margin);
  check_order("control.hard_margin", options.control.hard_margin, "control.soft_margin", options.control.soft_margin);
  check_order("subgoal.read_radius", options.subgoal.read_radius, "map.scope", options.map.layout.scope);
  if (!(options.memory.range_min < options.memory.range_max))
    fail("option 'memory.range_min': less than memory.range_max = {} m expected, got {}", options.memory.range_max,
         options.memory.range_min);
}

}  // namespace meander
