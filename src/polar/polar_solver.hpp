// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <vector>

#include "polar/aligned.hpp"
#include "polar/polar_weights.hpp"
#include "polar/projection.hpp"

namespace meander {

namespace polar {
struct LineSystem;
struct LineKernels;
}  // namespace polar

struct PolarSolverOptions {
  int passes = 2;
  bool exact = false;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, PolarSolverOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"passes", "", "sweeps from the target round the map and back", 1, 1000}, o.passes);
  visit(Field{"exact", "", "sweep until nothing changes any more"}, o.exact);
}

/// The equilibrium activation of a polar map whose target lies in sector 0. It is the solution of a linear system with
/// positive couplings and a leak: there is exactly one, and whatever the order of the updates, they approach it.
///
/// One pass: radial lines solved exactly, sector after sector from the target on both sides to the far side and back,
/// so that activation gets around any obstacle within a pass; then the inner rings, whose units couple strongly
/// sideways, ring by ring. Allocates nothing once made.
class PolarSolver {
 public:
  /// With these inner loops; none: the widest of polar::line_kernels().
  PolarSolver(const PolarLayout& layout, std::vector<RingWeights> weights, const polar::LineKernels* kernels = nullptr);

  /// Other weights for the same numbers of rings and sectors, whose places may have moved.
  void arrange(const PolarLayout& layout, const std::vector<RingWeights>& weights);

  /// The target unit, at ring `target` of sector 0, has activation 1 and is never obstructed.
  void solve(const ObstructedUnits& obstructed, int target, const PolarSolverOptions& options = {});

  double activation(int ring, int sector) const { return values_[index(sector) + static_cast<std::size_t>(ring)]; }
  /// How far from the equilibrium: the largest relative error of a unit's equation among the units that have any
  /// activation.
  double residual(const ObstructedUnits& obstructed) const;
  int passes_used() const { return passes_used_; }
  const std::vector<RingWeights>& weights() const { return weights_; }

 private:
  std::size_t index(int sector) const { return static_cast<std::size_t>(sector) * stride_ + kPad; }
  /// Of a unit's equation; sectors of other widths have other lateral weights.
  double total(int ring, int sector) const;
  const double* factors(int sector, int next);
  void prepare(const ObstructedUnits& obstructed, int target);
  void copy_factors(std::span<const std::uint64_t> bits, int target, int sector);
  void open_rings(const ObstructedUnits& obstructed, int sector);
  double inflow(int ring, int sector) const;
  polar::LineSystem system();

  static constexpr std::size_t kPad = 8;  ///< empty units on both sides of a line, read but never written
  const polar::LineKernels* kernels_;
  int rings_;
  int sectors_;
  int padded_;  ///< rings, in whole blocks of eight
  std::size_t stride_;
  std::vector<RingWeights> weights_;
  bool uneven_ = false;          ///< sectors differ in width
  std::vector<double> shares_;   ///< of the lateral weights, to the left of each sector and to the right
  polar::AlignedNumbers table_;  ///< line factors by next obstructed ring outwards and ring; one for all, or per sector
  std::vector<char> made_;       ///< rows of it that hold for the present weights
  polar::AlignedNumbers values_;  ///< activation, line by line
  polar::AlignedNumbers source_;
  polar::AlignedNumbers per_ring_;     ///< weights as arrays
  polar::AlignedNumbers factors_;      ///< of all units
  std::vector<const double*> factor_;  ///< each sector's
  polar::AlignedNumbers inner_;        ///< of the inner rings
  int target_ = 0;
  int passes_used_ = 0;
};

}  // namespace meander
