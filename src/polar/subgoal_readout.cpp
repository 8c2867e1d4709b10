// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/subgoal_readout.hpp"

#include <algorithm>

namespace meander {
namespace {

/// e^x by its series, with the same bits everywhere.
double exponential(double x) {
  constexpr int kHalvings = 10;
  double sum = 1, term = 1;
  for (int k = 1; k < 12; ++k) {
    term *= x / (1 << kHalvings) / k;
    sum += term;
  }
  for (int k = 0; k < kHalvings; ++k) sum *= sum;
  return sum;
}

/// The most active unit of a ring among the sectors at most `reach` from `middle`; the one nearest to the target's
/// sector of several equal ones.
int most_active(const PolarState& state, int ring, int middle, int reach) {
  const PolarLayout& layout = state.layout;
  int best = layout.wrapped(middle);
  for (int k = 1; k <= reach; ++k)
    for (const int sector : {layout.wrapped(middle + k), layout.wrapped(middle - k)})
      if (state.solver.activation(ring, sector) > state.solver.activation(ring, best)) best = sector;
  return best;
}

}  // namespace

int target_ring(const PolarLayout& layout, double distance) {
  if (distance >= layout.scope()) return layout.rings() - 1;
  return std::clamp(layout.nearest_ring(distance), 1, layout.rings() - 2);
}

SubgoalReadout::SubgoalReadout(const SubgoalReadoutOptions& options, double kappa)
    : options_(options), advantage_(kappa > 0 ? exponential(kappa * options.hysteresis) : options.hysteresis_ratio) {}

/// [LM99+] Read some way off the centre: around it the activation is nearly the same in all directions, and its
/// difference between two sides is what settles last. Hysteresis keeps the robot from wavering between two ways.
int SubgoalReadout::direction(const PolarState& state, int ring) const {
  const int best = most_active(state, ring, 0, state.layout.sectors() / 2);
  if (!state.previous || options_.hysteresis <= 0) return best;
  const int reach = std::min(options_.hysteresis_sectors, state.layout.sectors() / 2);
  if (state.layout.apart(best, *state.previous) <= reach) return best;
  const int kept = most_active(state, ring, *state.previous, reach);
  return state.solver.activation(ring, best) < advantage_ * state.solver.activation(ring, kept) ? kept : best;
}

std::optional<PolarSubgoal> SubgoalReadout::operator()(const PolarState& state) const {
  const PolarLayout& layout = state.layout;
  const int read =
      std::clamp(layout.nearest_ring(options_.read_radius), 1, std::min(state.target_ring, layout.rings() - 1));
  PolarSubgoal subgoal;
  subgoal.sector = direction(state, read);
  const auto activation = [&](int ring) { return state.solver.activation(ring, subgoal.sector); };
  if (!(activation(read) > 0)) return std::nullopt;
  subgoal.ring = read;
  while (subgoal.ring + 1 < layout.rings() && activation(subgoal.ring + 1) > activation(subgoal.ring)) ++subgoal.ring;
  // [LM99+] The target itself where the way to it is straight: its unit may be some way off.
  subgoal.exact = subgoal.sector == 0 && subgoal.ring == state.target_ring && state.target.norm() < layout.scope();
  subgoal.position = subgoal.exact ? state.target : layout.position(subgoal.ring, subgoal.sector);
  return subgoal;
}

}  // namespace meander
