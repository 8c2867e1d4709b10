// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <vector>

#include "polar/polar_layout.hpp"

namespace meander {

/// What a unit's activation is made of: v = (inward v_in + outward v_out + lateral (v_left + v_right) + ...) / total.
/// Obstructed neighbours count as 0. The same for all sectors of a ring.
struct RingWeights {
  double inward = 0;            ///< of the next unit towards the centre
  double outward = 0;           ///< of the next unit away from it
  double lateral = 0;           ///< of each neighbour on the ring
  double inward_diagonal = 0;   ///< of each neighbour's inner neighbour
  double outward_diagonal = 0;  ///< of each neighbour's outer neighbour
  double total = 1;             ///< sum of all of them and of the leak
  bool operator==(const RingWeights&) const = default;
};

enum class PolarWeights { finite_volume, euclidean, lattice };
template <>
struct EnumNames<PolarWeights> {
  static constexpr std::pair<PolarWeights, const char*> entries[] = {{PolarWeights::finite_volume, "finite_volume"},
                                                                     {PolarWeights::euclidean, "euclidean"},
                                                                     {PolarWeights::lattice, "lattice"}};
};

/// Weights of a ring in (0, rings - 1], by a function of one's own. Ring 0 follows ring 1.
using OwnWeights = std::function<RingWeights(const PolarLayout&, int ring)>;

/// The weights of all rings. `kappa` [1/m] is the decay of finite volumes. Throws ArgumentError when a weight is
/// negative or not finite, or when a stable equilibrium is not sure to exist.
std::vector<RingWeights> ring_weights(const PolarLayout& layout, PolarWeights kind, double kappa);
std::vector<RingWeights> ring_weights(const PolarLayout& layout, const OwnWeights& own);
/// Finite volumes into an array of as many rings, for sectors of average width. Allocates nothing.
void finite_volumes(const PolarLayout& layout, double kappa, std::vector<RingWeights>& weights);

/// The largest eigenvalue of the connections: activation stays bounded while every total exceeds it [LM99]. The
/// eigenvector is the same in all sectors, because the weights are and none is negative; the centre follows ring 1.
double largest_eigenvalue(const std::vector<RingWeights>& weights);

}  // namespace meander
