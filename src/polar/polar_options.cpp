// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_options.hpp"

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

}  // namespace meander
