// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>

#include "base/random.hpp"
#include "robot/contracts.hpp"
#include "topology/revisit.hpp"
#include "topology/topologic_map.hpp"
#include "topology/whisker_drive.hpp"

namespace meander::topology {

struct WanderOptions {
  int samples = 5000;  ///< to gather
  std::uint64_t seed = 1;
  int shortest = 60;                       ///< samples that a behaviour lasts at least
  int longest = 260;                       ///< and at most
  double half_width = 0.7853981633974483;  ///< contacts so near to the way block it [rad]
  double wall_turn = 0.2617993877991494;   ///< per sample towards a wall that was lost [rad]
  double lookahead = 1.0;                  ///< where it counts cells [m]
  double crowd = 0.7;                      ///< the radius in which it counts [m]
  RevisitOptions revisit;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WanderOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"samples", "", "to gather before it ends", 1, 1e9}, o.samples);
  visit(Field{"seed", "", "of its random choices", 0, 1.8446744073709552e19}, o.seed);
  visit(Field{"shortest", "", "samples that a behaviour lasts at least", 1, 1e6}, o.shortest);
  visit(Field{"longest", "", "samples that a behaviour lasts at most", 1, 1e6}, o.longest);
  visit(Field{"half_width", "rad", "contacts so near to the way block it", 0, 3.2}, o.half_width);
  visit(Field{"wall_turn", "rad", "turn per sample towards a wall that was lost", 0, 3.2}, o.wall_turn);
  visit(Field{"lookahead", "m", "how far ahead it counts cells of the map", 0, 100}, o.lookahead);
  visit(Field{"crowd", "m", "radius of the area in which it counts them", 0, 100}, o.crowd);
  visit(Field{"revisit", "", "how it drives to doubted links"}, o.revisit);
}

/// The exploration of [Z] section 4 (its strategies stand in a paper that cannot be had): straight on and off at random
/// where it is blocked, along walls, or to where the map has the fewest cells; one after the other, for random times.
/// [Z+] With `revisit.share` it also drives to links that are doubted and tries to pass them.
/// Feeds every sample to the map.
Guide wander(const std::shared_ptr<TopologicMap>& map, const WanderOptions& options = {});

}  // namespace meander::topology
