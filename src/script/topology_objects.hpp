// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/kit_object.hpp"
#include "script/kit_options.hpp"
#include "topology/minimal_map.hpp"
#include "topology/topologic_map.hpp"

namespace meander::topology {

inline std::size_t native_size(const TopologicMap& map) {
  const CellPool& cells = map.net().cells();
  return sizeof(TopologicMap) + static_cast<std::size_t>(cells.slots()) * (200 + 4 * cells.stride());
}
inline std::size_t native_size(const MinimalMap& map) { return sizeof(MinimalMap) + map_bytes(map, 16); }

}  // namespace meander::topology

namespace meander::script {

template <>
struct ObjectName<topology::TopologicMap> {
  static constexpr const char* value = "topologic_map";
};
template <>
struct ObjectName<topology::MinimalMap> {
  static constexpr const char* value = "minimal_map";
};

/// Scripts count cells from 1.
inline int cell_of(const topology::TopologicMap& map, int number) {
  if (number < 1 || !map.net().cells().alive(number - 1)) fail("place {} is not in the map", number);
  return number - 1;
}

}  // namespace meander::script

/// A simulation `s` of ALICE that has driven a little, and the map `m` that it made.
#define EXAMPLE_TOPOLOGY                                                                                               \
  "s = meander.sim.new { world = meander.world.open 'worlds/alice_loop.toml', robot = 'alice', drift = 'alice' } m = " \
  "meander.topology.map {} s:drive { navigator = meander.topology.whiskers {}, guide = meander.topology.wander { map " \
  "= m, samples = 200 } } "
