// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "planning/neural_solution.hpp"
#include "planning/tile_queue.hpp"

namespace meander {
namespace {

constexpr double kLn2 = 0.69314718055994530942;

/// How fast activation falls at least with distance, in bits a cell: a plane wave exp(k u . x) that solves the
/// equations of open floor bounds what one cell can mean to another, and obstacles only make it less.
double least_decay(const NeuralNet& net) {
  if (!net.weights.empty()) return -natural_log(net.steepness) / kLn2 / 2.24;  // no unit outdoes its best neighbour
  const auto gain = [&](double k, Vec2 u) {
    double sum = 0;
    const std::span<const LatticeStep> steps = lattice_steps(net.lattice);
    for (std::size_t step = 0; step < steps.size(); ++step) {
      const Vec2 way = cell_center(net.lattice, {steps[step].dx, steps[step].dy}) - cell_center(net.lattice, {0, 0});
      const double x = k * way.dot(u);
      sum += net.weight[step] * (x > 0 ? 1 / falling_exponential(x) : falling_exponential(-x));
    }
    return sum;
  };
  double low = 0, high = 8;
  for (int i = 0; i < 30; ++i) {
    const double k = (low + high) / 2;
    double most = 0;
    for (int n = 0; n < 24; ++n) {
      const SinCos turn = sin_cos(kPi / 24 * n);
      most = std::max(most, gain(k, {turn.cos, turn.sin}));
    }
    (most < 1 ? low : high) = k;
  }
  return low / kLn2;
}

class Guided {
 public:
  Guided(const NeuralNet& net, Cell start, NeuralSolution& solution)
      : net_(net),
        v_(solution.v),
        solution_(solution),
        start_(start),
        decay_(least_decay(net)),
        key_(net.links.size(), kNever) {}

  void run(const Work& work) {
    for (const std::int32_t target : net_.targets) spread(target, 1, {1, 0});
    std::vector<std::int32_t> bucket;
    while (queue_.pop(bucket) && queue_.turn() <= enough())
      for (const std::int32_t i : bucket) {
        if (key_[static_cast<std::size_t>(i)] != queue_.turn()) continue;  // it was taken up before
        key_[static_cast<std::size_t>(i)] = kNever;
        if (++solution_.relaxations % 4096 == 0) work.poll();
        relax(i);
      }
    solution_.complete = false;
  }

 private:
  static constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();
  static constexpr int kMargin = 14;  ///< bits
  static constexpr double kLeast = 1e-6;

  static double bits(const Extended& v) { return -natural_log(v) / kLn2; }

  /// Beyond this key nothing matters to the start.
  std::int32_t enough() const {
    const Extended& v = v_[static_cast<std::size_t>(net_.index(start_))];
    return v.zero() ? kNever : static_cast<std::int32_t>(bits(v)) + kMargin;
  }

  void relax(std::int32_t i) {
    Extended& own = v_[static_cast<std::size_t>(i)];
    const Extended u = response(net_, v_, i);
    if (u.zero()) return;
    const double change = std::abs(u.value - own.in_block(u.block)) / u.value;
    own = u;
    if (change > kLeast) spread(i, change, u);
  }

  /// Neighbours wait until nothing is left that means more to the start.
  void spread(std::int32_t i, double change, const Extended& v) {
    const double key = bits(v) - natural_log(change) / kLn2;
    net_.for_each_link(i, [&](std::int32_t j, int) {
      if (net_.is_target(j)) return;
      const double way = (cell_center(net_.lattice, net_.cell(j)) - cell_center(net_.lattice, start_)).norm();
      std::int32_t& place = key_[static_cast<std::size_t>(j)];
      const auto wanted = static_cast<std::int32_t>(key + decay_ * std::max(0.0, way - 1));
      if (std::max(wanted, queue_.turn()) < place) place = queue_.push(j, wanted);
    });
  }

  const NeuralNet& net_;
  Activation& v_;
  NeuralSolution& solution_;
  Cell start_;
  double decay_;
  std::vector<std::int32_t> key_;
  TileQueue queue_;
};

}  // namespace

NeuralSolution solve_for_start(const NeuralNet& net, Cell start, const Work& work) {
  NeuralSolution solution{.v = resting(net), .solver = "for_start"};
  Guided(net, start, solution).run(work);
  solution.residual = scan_residuals(net, solution.v, work, [](std::int32_t, double) {});
  return solution;
}

}  // namespace meander
