// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "planning/extended.hpp"
#include "planning/landscape.hpp"
#include "planning/neural_map_options.hpp"

namespace meander {

/// The units of a neural map and what connects them, as flat arrays with a rim of blocked units all round. [LM99]
/// Neural maps for global path planning. Steps are those of the lattice: k and k ^ 1 are opposite.
struct NeuralNet {
  static constexpr std::uint32_t kOddRow = 1u << 31, kTarget = 1u << 30, kSteps = (1u << 20) - 1;
  static constexpr int kRim = 2;

  Lattice lattice = Lattice::rectangular;
  int width = 0;  ///< of the map
  int height = 0;
  int stride = 0;
  int steps = 0;
  std::vector<std::uint32_t> links;                      ///< per unit: bit k where step k is open, and the flags above
  std::array<std::array<std::int32_t, 20>, 2> offset{};  ///< of even and odd rows
  std::array<double, 20> weight{};                       ///< beta w, where cost is length
  std::vector<float> weights;                            ///< else w, `steps` for every unit
  double beta = 0;
  double steepness = 0;  ///< beta times the largest sum of a unit's weights
  std::vector<std::int32_t> targets;

  std::int32_t index(Cell cell) const { return (cell.y + kRim) * stride + cell.x + kRim; }
  Cell cell(std::int32_t i) const { return {i % stride - kRim, i / stride - kRim}; }
  bool is_target(std::int32_t i) const { return (links[static_cast<std::size_t>(i)] & kTarget) != 0; }
  /// beta w_ij where j lies one step k from i.
  double weight_of(std::int32_t i, int k) const {
    if (weights.empty()) [[likely]]
      return weight[static_cast<std::size_t>(k)];
    return beta *
           static_cast<double>(
               weights[static_cast<std::size_t>(i) * static_cast<std::size_t>(steps) + static_cast<std::size_t>(k)]);
  }
  /// Calls visit(j, k) for the units connected with i.
  template <class Visit>
  void for_each_link(std::int32_t i, Visit visit) const {
    const std::uint32_t mask = links[static_cast<std::size_t>(i)];
    const auto& to = offset[(mask & kOddRow) != 0];
    std::uint32_t rest = mask & kSteps;
    if (rest == 0xff) {  // the usual unit, worth a loop of fixed length
      for (int k = 0; k < 8; ++k) visit(i + to[static_cast<std::size_t>(k)], k);
      return;
    }
    for (; rest != 0; rest &= rest - 1) {
      const int k = std::countr_zero(rest);
      visit(i + to[static_cast<std::size_t>(k)], k);
    }
  }
};

NeuralNet neural_net(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work = {});

/// The unit's connections anew, after cells near it were blocked or freed.
void relink(NeuralNet& net, const PlanningProblem& problem, Cell cell);

using Activation = std::vector<Extended>;  ///< v of every unit of a net

/// Targets at 1, all others at 0.
Activation resting(const NeuralNet& net);

/// What the unit's equation asks of it: Phi(beta sum_j w_ij v_j).
inline Extended response(const NeuralNet& net, const Activation& v, std::int32_t i) {
  std::int32_t base = Extended::kZeroBlock;
  net.for_each_link(i, [&](std::int32_t j, int) { base = std::max(base, v[static_cast<std::size_t>(j)].block); });
  double sum = 0;
  net.for_each_link(
      i, [&](std::int32_t j, int k) { sum += net.weight_of(i, k) * v[static_cast<std::size_t>(j)].in_block(base); });
  return extended(base == 0 ? squash(sum) : sum, base);
}

/// |v / u - 1|; 0 where both are 0.
double relative_error(const Extended& v, const Extended& u);

/// Largest relative error of a unit's equation; calls visit(i, error) for every free unit that is no target.
template <class Visit>
double scan_residuals(const NeuralNet& net, const Activation& v, const Work& work, Visit visit) {
  double worst = 0;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(v.size()); ++i) {
    if (i % 4096 == 0) work.poll();
    const std::uint32_t mask = net.links[static_cast<std::size_t>(i)];
    if ((mask & NeuralNet::kSteps) == 0 || (mask & NeuralNet::kTarget) != 0) continue;
    const double error = relative_error(v[static_cast<std::size_t>(i)], response(net, v, i));
    visit(i, error);
    worst = std::max(worst, error);
  }
  return worst;
}

}  // namespace meander
