// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_solver.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "polar/polar_lines.hpp"

namespace meander {
namespace {

constexpr int kInner = 16;      ///< rings that are also solved ring by ring
constexpr int kRingArrays = 6;  ///< weights per ring
constexpr int kRingSolves = 8;  ///< per pass
constexpr int kExactPasses = 5000;
constexpr double kExact = 1e-13;  ///< relative

bool has_diagonals(const std::vector<RingWeights>& weights) {
  return std::any_of(weights.begin(), weights.end(),
                     [](const RingWeights& w) { return w.inward_diagonal > 0 || w.outward_diagonal > 0; });
}

}  // namespace

PolarSolver::PolarSolver(const PolarLayout& layout, std::vector<RingWeights> weights, const polar::LineKernels* kernels)
    : kernels_(kernels ? kernels : &polar::line_kernels().back()),
      rings_(layout.rings()),
      sectors_(layout.sectors()),
      padded_((layout.rings() + 7) / 8 * 8),
      stride_(static_cast<std::size_t>(padded_) + 2 * kPad),
      weights_(std::move(weights)) {
  const auto m = static_cast<std::size_t>(sectors_);
  // Loads of the inner rings may reach past a short line into the next, and past the last one.
  values_.resize((m + 1) * stride_ + 2 * kInner);
  source_.resize(stride_ + 2 * kInner);
  factors_.resize(m * static_cast<std::size_t>(padded_));
  factor_.resize(m);
  shares_.resize(2 * m);
  uneven_ = !layout.even();
  made_.resize((uneven_ ? m : 1) * (static_cast<std::size_t>(rings_) + 1));
  table_.resize(made_.size() * static_cast<std::size_t>(padded_));
  per_ring_.resize(kRingArrays * (stride_ + 2 * kInner));
  inner_.resize(5 * kInner * (m + 1) + 2 * kInner);
  for (int lane = 0; lane < kInner; ++lane) {
    const bool solved = lane + 1 < rings_ - 1;
    inner_[static_cast<std::size_t>(lane)] = solved ? 0 : 1;
    inner_[static_cast<std::size_t>(kInner + lane)] = solved ? 1 : 0;
  }
  arrange(layout, weights_);
}

void PolarSolver::arrange(const PolarLayout& layout, const std::vector<RingWeights>& weights) {
  weights_ = weights;
  double* at = per_ring_.data() + kPad;
  for (const auto member : {&RingWeights::inward, &RingWeights::outward, &RingWeights::lateral,
                            &RingWeights::inward_diagonal, &RingWeights::outward_diagonal, &RingWeights::total}) {
    const bool total = member == &RingWeights::total;
    if (total) std::fill(at - kPad, at - kPad + stride_ + 2 * kInner, 1.0);
    for (std::size_t i = 0; i < weights_.size(); ++i)
      at[i] = weights_[i].*member - (total && uneven_ ? 2 * weights_[i].lateral : 0);
    at += stride_ + 2 * kInner;
  }
  // Flow over a border goes by the distance of the sectors, per width of the sector: 1 where all are alike.
  const double square = layout.spacing() * layout.spacing();
  for (int k = 0; k < sectors_; ++k) {
    const auto left = static_cast<std::size_t>(k), right = static_cast<std::size_t>(k + sectors_);
    shares_[left] = uneven_ ? square / (layout.width(k) * layout.gap(k == 0 ? sectors_ - 1 : k - 1)) : 1;
    shares_[right] = uneven_ ? square / (layout.width(k) * layout.gap(k)) : 1;
  }
  std::fill(made_.begin(), made_.end(), char{0});
}

double PolarSolver::total(int ring, int sector) const {
  const RingWeights& w = weights_[static_cast<std::size_t>(ring)];
  if (!uneven_) return w.total;
  const auto k = static_cast<std::size_t>(sector);
  return w.total - 2 * w.lateral + w.lateral * (shares_[k] + shares_[k + static_cast<std::size_t>(sectors_)]);
}

/// c_i = 1 / (total_i - outward_i e_{i+1}), e_i = inward_i c_i, from the next obstructed ring inwards: made when first
/// wanted.
const double* PolarSolver::factors(int sector, int next) {
  const std::size_t at = static_cast<std::size_t>(uneven_ ? sector : 0) * (static_cast<std::size_t>(rings_) + 1) +
                         static_cast<std::size_t>(next);
  double* row = table_.data() + at * static_cast<std::size_t>(padded_);
  if (made_[at]) return row;
  double e = 0;
  for (int i = next; i-- > 0;) {
    const RingWeights& w = weights_[static_cast<std::size_t>(i)];
    row[i] = 1 / (total(i, sector) - w.outward * e);
    e = w.inward * row[i];
  }
  made_[at] = 1;
  return row;
}

polar::LineSystem PolarSolver::system() {
  const auto m = static_cast<std::size_t>(sectors_);
  const auto ring = [&](std::size_t k) { return per_ring_.data() + k * (stride_ + 2 * kInner) + kPad; };
  const auto inner = [&](std::size_t k) { return inner_.data() + 2 * kInner + k * kInner * (m + 1); };
  return {.sectors = sectors_,
          .padded = padded_,
          .stride = stride_,
          .diagonals = has_diagonals(weights_),
          .uneven = uneven_,
          .whole = kInner < rings_ - 1,
          .v = values_.data() + kPad,
          .factor = factor_.data(),
          .source = source_.data() + kPad,
          .inward = ring(0),
          .outward = ring(1),
          .lateral = ring(2),
          .inward_diagonal = ring(3),
          .outward_diagonal = ring(4),
          .total = ring(5),
          .left_share = shares_.data(),
          .right_share = shares_.data() + m,
          .ring_open = inner(0),
          .ring_q = inner(1),
          .ring_p = inner(2),
          .ring_z = inner(3),
          .ring_y = inner(4),
          .ring_keep = inner_.data(),
          .ring_take = inner_.data() + kInner};
}

/// The line's factors from the table: a run between two obstructed units depends on its outer end alone.
void PolarSolver::copy_factors(std::span<const std::uint64_t> bits, int target, int sector) {
  const auto k = static_cast<std::size_t>(sector);
  double* factor = factors_.data() + k * static_cast<std::size_t>(padded_);
  factor_[k] = factor;
  const auto copy = [&](int from, int next) {
    const double* row = factors(sector, next);
    std::copy(row + from, row + next, factor + from);
  };
  int next = rings_;
  for (std::size_t word = bits.size(); word-- > 0;) {
    std::uint64_t left = bits[word];
    if (target >= 0 && static_cast<std::size_t>(target) >> 6 == word) left |= std::uint64_t{1} << (target & 63);
    while (left != 0) {
      const int high = 63 - std::countl_zero(left), count = std::countl_one(left << (63 - high));
      const int low = high - count + 1, first = static_cast<int>(word) * 64 + low;
      copy(first + count, next);
      std::fill(factor + first, factor + first + count, 0.0);
      next = first;
      left = low == 0 ? 0 : left & ~(~std::uint64_t{0} << low);
    }
  }
  copy(0, next);
}

void PolarSolver::open_rings(const ObstructedUnits& obstructed, int sector) {
  const auto bits = obstructed.sector_bits(sector);
  double* open = inner_.data() + 2 * kInner + static_cast<std::size_t>(sector) * kInner;
  for (int lane = 0; lane < kInner; ++lane) open[lane] = bits[0] >> (lane + 1) & 1 ? 0.0 : 1.0;
  if (sector == 0 && target_ <= kInner) open[target_ - 1] = 0;
}

void PolarSolver::prepare(const ObstructedUnits& obstructed, int target) {
  target_ = std::clamp(target, 1, rings_ - 1);
  std::fill(values_.begin(), values_.end(), 0.0);
  std::fill(source_.begin(), source_.end(), 0.0);
  source_[kPad + static_cast<std::size_t>(target_)] = 1;
  for (int k = 0; k < sectors_; ++k) {
    open_rings(obstructed, k);
    const auto bits = obstructed.sector_bits(k);
    const bool open = k > 0 && std::all_of(bits.begin(), bits.end(), [](std::uint64_t word) { return word == 0; });
    if (open)
      factor_[static_cast<std::size_t>(k)] = factors(k, rings_);
    else
      copy_factors(bits, k == 0 ? target_ : -1, k);
  }
  kernels_->factor_rings(system());
}

void PolarSolver::solve(const ObstructedUnits& obstructed, int target, const PolarSolverOptions& options) {
  prepare(obstructed, target);
  const polar::LineSystem s = system();
  const int most = options.exact ? kExactPasses : options.passes;
  for (passes_used_ = 0; passes_used_ < most; ++passes_used_) {
    kernels_->sweep_lines(s);
    for (int k = 0; k < kRingSolves; ++k) kernels_->solve_rings(s);
    if (options.exact && residual(obstructed) < kExact) break;
  }
}

double PolarSolver::inflow(int ring, int sector) const {
  const RingWeights& w = weights_[static_cast<std::size_t>(ring)];
  const double* here = values_.data() + index(sector) + ring;
  const double* left = values_.data() + index(sector == 0 ? sectors_ - 1 : sector - 1) + ring;
  const double* right = values_.data() + index(sector == sectors_ - 1 ? 0 : sector + 1) + ring;
  const double *left_share = shares_.data() + sector, *right_share = left_share + sectors_;
  return w.inward * here[-1] + w.outward * here[1] + w.lateral * (*left_share * left[0] + *right_share * right[0]) +
         w.inward_diagonal * (left[-1] + right[-1]) + w.outward_diagonal * (left[1] + right[1]);
}

double PolarSolver::residual(const ObstructedUnits& obstructed) const {
  double worst = 0;
  for (int sector = 0; sector < sectors_; ++sector)
    for (int ring = 0; ring < rings_; ++ring) {
      if (obstructed.test(ring, sector) || (sector == 0 && ring == target_)) continue;
      const double in = inflow(ring, sector);
      const double own = activation(ring, sector) * total(ring, sector);
      if (in > 0 || own > 0) worst = std::max(worst, std::abs(in - own) / std::max(in, own));
    }
  return worst;
}

}  // namespace meander
