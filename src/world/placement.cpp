// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/placement.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "world/validity.hpp"

namespace meander {
std::vector<Spot> spots_of(const Item& item) {
  std::vector<Spot> spots;
  if (const auto* place = std::get_if<Place>(&item)) spots.push_back({label(item), place->position, 0});
  if (const auto* mover = std::get_if<Mover>(&item)) {
    spots.push_back({label(item), mover->disc.center, mover->disc.radius});
    for (std::size_t i = 0; i < mover->waypoints.size(); ++i)
      spots.push_back({fmt::format("waypoint {} of {}", i + 1, label(item)), mover->waypoints[i], 0});
  }
  return spots;
}

std::vector<Spot> spots_of(const Header& header) {
  if (!header.start) return {};
  return {{"the start", header.start->position(), 0}};
}

void check_within(const Spot& spot, const Box& bounds) {
  if (!bounds.contains(spot.position))
    fail("{}: {} is outside the bounds {} to {}", spot.what, point_text(spot.position), point_text(bounds.low),
         point_text(bounds.high));
}

void check_apart(const Item& blocking, const Spot& spot) {
  const Shape* shape = blocking_shape(blocking);
  if (shape && distance(*shape, spot.position) < std::max(spot.radius, kTouch))
    fail("{} {} {} at {}", label(blocking), std::holds_alternative<Door>(blocking) ? "(closed) covers" : "covers",
         spot.what, point_text(spot.position));
}

}  // namespace meander
