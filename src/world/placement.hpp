// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "world/edit.hpp"

namespace meander {

/// Ground that must stay free and within the bounds: the start, a place, a mover and its waypoints. Obstacles
/// themselves may overlap each other and reach beyond the bounds, lights may be anywhere, and a door counts only while
/// closed. Points are free when they are outside solids and not on a thin wall; room for a body is the simulation's
/// question, because the world does not know the body. A mover's own disc must be free where it starts.
struct Spot {
  std::string what;  ///< "place 'hall'", "start", "mover 'anna'", "waypoint 2 of mover 'anna'"
  Vec2 position{0, 0};
  double radius = 0;  ///< what must be free around it [m]
};

std::vector<Spot> spots_of(const Item& item);
std::vector<Spot> spots_of(const Header& header);

/// Throws "place 'hall': (12, 3) is outside the bounds (0, 0) to (10, 10)".
void check_within(const Spot& spot, const Box& bounds);

/// Throws "obstacle 'crate' would stand on place 'hall' at (1, 2)" when the blocking item covers the spot.
void check_apart(const Item& blocking, const Spot& spot);

}  // namespace meander
