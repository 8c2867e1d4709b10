// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <optional>

#include "base/work.hpp"
#include "indicator/path_network.hpp"

namespace meander {

/// Weights of the energy whose minimum should be the shortest route.
struct HopfieldOptions {
  double row = 2.53, column = 0.83, bias = 3.89, length = 0.41, missing = 2.45;
  double gain = 4.36, step = 0.05;
  int steps = 400;
  std::uint64_t seed = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, HopfieldOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"row", "", "inhibition between the neurons of a row", 0, 100}, o.row);
  visit(Field{"column", "", "inhibition between the neurons of a column", 0, 100}, o.column);
  visit(Field{"bias", "", "excitation of every neuron", -100, 100}, o.bias);
  visit(Field{"length", "", "weight of the lengths", 0, 100}, o.length);
  visit(Field{"missing", "", "what a missing link costs, in longest links", 0, 100}, o.missing);
  visit(Field{"gain", "", "of a neuron's response", 0.01, 1000}, o.gain);
  visit(Field{"step", "", "of the relaxation, in time constants", 1e-4, 1}, o.step);
  visit(Field{"steps", "", "of each layer's relaxation", 1, 100000}, o.steps);
  visit(Field{"seed", "", "of the small numbers that the neurons begin with"}, o.seed);
}

/// What [DG] section 4 seems to describe when read as the network of Hopfield and Tank: each layer relaxes for itself,
/// du/dt = -u - A (others of the row) - B (others of the column) + C - D (lengths to the rows beside). Kept to show why
/// it is not what the explorer uses: beyond some twenty indicators most layers come to rest on what is no route at all.
/// None: no layer came to rest on a valid route.
std::optional<Route> hopfield_path(const RouteLinks& links, int start, int goal, const HopfieldOptions& options = {},
                                   const Work& work = {});

}  // namespace meander
