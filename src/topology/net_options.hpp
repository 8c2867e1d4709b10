// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"

namespace meander::topology {

/// How a net of cells grows and adapts ([Z] sections 3-2 and 3-3).
struct NetOptions {
  double insert_distance = 1.0;     ///< rho_s: a situation farther than this from every cell becomes one
  double accept_distance = 0.8;     ///< d_acc: border between hit and miss
  double adapt = 0.02;              ///< eps_o of a miss; a hit multiplies it by `settle`
  double adapt_neighbours = 0.002;  ///< eps_n of a miss; 0 after a hit
  double settle = 0.9;              ///< eps_delta
  double fade = 0.05;               ///< a_red: what the winner's other links lose together
  int misses_to_insert = 200;       ///< n_insert; 0: no statistical insertion
  int least_component = 3;          ///< smaller pieces of the graph are dropped
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, NetOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"insert_distance", "", "a situation farther than this from every cell becomes a cell", 1e-3, 100},
        o.insert_distance);
  visit(Field{"accept_distance", "", "border between hit and miss", 0, 100}, o.accept_distance);
  visit(Field{"adapt", "", "share by which the winner moves after a miss", 0, 1}, o.adapt);
  visit(Field{"adapt_neighbours", "", "share by which its neighbours move after a miss", 0, 1}, o.adapt_neighbours);
  visit(Field{"settle", "", "every hit multiplies the winner's share by this", 0, 1}, o.settle);
  visit(Field{"fade", "", "what the winner's other links lose together", 0, 1}, o.fade);
  visit(Field{"misses_to_insert", "", "a cell is put at the worst place after so many misses; 0: never", 0, 1e9},
        o.misses_to_insert);
  visit(Field{"least_component", "", "pieces of the graph with fewer cells are dropped", 0, 100}, o.least_component);
}

/// One unit of distance between two situations ([Z] leaves the weights open).
struct Scales {
  double position = 0.35;  ///< [m]
  double light = 0.15;     ///< root mean square over the ring
  double touch = 0.30;     ///< root mean square over the ring
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, Scales>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"position", "m", "places so far apart are clearly different", 1e-3, 1000}, o.position);
  visit(Field{"light", "", "light rings so different (root mean square) are clearly different", 1e-6, 1000}, o.light);
  visit(Field{"touch", "", "touch rings so different (root mean square) are clearly different", 1e-6, 1000}, o.touch);
}

}  // namespace meander::topology
