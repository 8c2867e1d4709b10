// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "topology/minimal_map.hpp"

namespace meander::topology {

/// The minimal model with one byte per value, for micro-controllers ([Z] section 5): places on a grid of 255 x 255 over
/// the map, senses and weights in 255 steps. At most 254 lights and 254 touches; number 255 stands for none.
struct QuantisedMap {
  int touch = 0, light = 0;                   ///< sizes of the rings
  Vec2 low{0, 0};                             ///< of byte 0 [m]
  double step = 0;                            ///< metres per unit
  double touch_most = 0, light_most = 0;      ///< of byte 255
  std::vector<std::uint8_t> places;           ///< x, y, light, touch
  std::vector<std::uint16_t> links;           ///< pairs of places
  std::vector<std::uint8_t> weights;          ///< of the links
  std::vector<std::uint8_t> lights, touches;  ///< rows of the rings

  std::size_t place_count() const { return places.size() / 4; }
  std::size_t bytes() const {
    return places.size() + 2 * links.size() + weights.size() + lights.size() + touches.size();
  }
};

/// Throws ArgumentError for more than 254 lights or touches, or 65536 places.
QuantisedMap quantised(const MinimalMap& map);

/// A C header with the arrays and how to read them; `name` is a C identifier, or ArgumentError.
std::string c_source(const QuantisedMap& map, const std::string& name);

/// The place that a situation is most like, by position and the senses it links to; -1 in an empty map. Of the exact
/// model the number of its cell, of the quantised one the number of its place.
int recognise(const MinimalMap& map, const Situation& situation, const Scales& scales);
int recognise(const QuantisedMap& map, const Situation& situation, const Scales& scales);
/// Where that place is [m].
Vec2 position_of(const QuantisedMap& map, int place);

}  // namespace meander::topology
