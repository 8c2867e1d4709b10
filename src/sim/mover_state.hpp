// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "world/item.hpp"

namespace meander {

/// A mover of the world while it runs.
struct MoverState {
  Id id;
  Vec2 position{0, 0};
  double heading = 0;    ///< of the random walk [rad]
  std::size_t next = 0;  ///< station it is heading for: 0 is where it started, i the i-th waypoint
  bool waiting = false;  ///< stands still because something is in its way
};

}  // namespace meander
