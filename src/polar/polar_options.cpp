// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_options.hpp"

#include <algorithm>

namespace meander {

PolarOptions in_mode(PolarOptions options) {
  if (options.mode == PolarMode::full) return options;
  options.memory.contradictions = 0;
  options.subgoal.hysteresis = 0;
  options.trap.watch = false;
  // The zone around obstacles costs, and more at any speed alike.
  options.control.soft_margin = 0.20;
  options.control.soft_samples = 0.8;
  options.control.soft_speed_cost = 0;
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
