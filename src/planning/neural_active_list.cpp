// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <cmath>
#include <utility>

#include "planning/neural_solution.hpp"

namespace meander {
namespace {

/// Units to be updated, in rounds: those of the next are noted while this one goes on.
class ActiveList {
 public:
  explicit ActiveList(std::size_t units) : noted_(units, 0), seen_(units, 0) {}

  void note(std::int32_t i) {
    if (std::exchange(noted_[static_cast<std::size_t>(i)], std::uint8_t{1}) == 0) next_.push_back(i);
  }
  /// Its equation may have changed, be it ever so little.
  void see(std::int32_t i) {
    if (std::exchange(seen_[static_cast<std::size_t>(i)], std::uint8_t{1}) == 0) all_seen_.push_back(i);
  }
  const std::vector<std::int32_t>& seen() const { return all_seen_; }
  bool next_round(std::vector<std::int32_t>& round) {
    round.clear();
    round.swap(next_);
    return !round.empty();
  }
  void take(std::int32_t i) { noted_[static_cast<std::size_t>(i)] = 0; }

 private:
  std::vector<std::uint8_t> noted_, seen_;
  std::vector<std::int32_t> next_, all_seen_;
};

class Relaxation {
 public:
  Relaxation(const NeuralNet& net, NeuralSolution& solution, double threshold, const Work& work)
      : net_(net), solution_(solution), v_(solution.v), list_(net.links.size()), threshold_(threshold), work_(work) {
    const double root = std::sqrt(1 - net.steepness * net.steepness);
    over_ = kShare * (1 - root) / (1 + root);  // omega - 1 of the best over-relaxation
  }

  void note(std::int32_t i) {
    if (net_.is_target(i)) return;
    list_.see(i);
    list_.note(i);
  }
  const std::vector<std::int32_t>& seen() const { return list_.seen(); }

  void run() {
    std::vector<std::int32_t> round;
    while (list_.next_round(round))
      for (const std::int32_t i : round) {
        if (++solution_.relaxations % 4096 == 0) work_.poll();
        list_.take(i);
        relax(i);
      }
  }

 private:
  /// Where fewer neighbours are open less is over-relaxed: a corridor has no use for it.
  double over_relaxation(double gain) const {
    const double share = gain / net_.steepness;
    return 1 + over_ * share * share;
  }

  void relax(std::int32_t i) {
    Extended& own = v_[static_cast<std::size_t>(i)];
    const Extended u = response(net_, v_, i);
    if (u.zero()) return;
    const double old = own.in_block(u.block);
    double gain = 0;
    net_.for_each_link(i, [&](std::int32_t, int k) { gain += net_.weight_of(i, k); });
    double x = old == 0 ? kFirst * u.value : old + over_relaxation(gain) * (u.value - old);
    if (x < 0.5 * u.value || u.block == 0) x = u.value;
    own = extended(x, u.block);
    const double change = std::abs(x - old);
    if (change > threshold_ * x) list_.note(i);
    spread(i, change, u.block);
  }

  /// Neighbours on whose value the change has an effect.
  void spread(std::int32_t i, double change, std::int32_t block) {
    if (change == 0) return;
    net_.for_each_link(i, [&](std::int32_t j, int k) {
      if (net_.is_target(j)) return;
      list_.see(j);
      const Extended& other = v_[static_cast<std::size_t>(j)];
      if (net_.weight_of(j, k ^ 1) * change > threshold_ * other.in_block(block)) note(j);
    });
  }

  static constexpr double kFirst = 1.2, kShare = 0.97;
  const NeuralNet& net_;
  NeuralSolution& solution_;
  Activation& v_;
  ActiveList list_;
  double threshold_, over_ = 0;
  const Work& work_;
};

}  // namespace

void settle(const NeuralNet& net, NeuralSolution& solution, std::vector<std::int32_t> active, double tolerance,
            const Work& work) {
  for (double threshold = tolerance / 20; !active.empty(); threshold /= 2) {
    Relaxation relaxation(net, solution, threshold, work);
    for (const std::int32_t i : active) relaxation.note(i);
    relaxation.run();
    active.clear();
    solution.residual = 0;
    std::size_t looked = 0;
    for (const std::int32_t i : relaxation.seen()) {
      if (++looked % 4096 == 0) work.poll();
      const double error = relative_error(solution.v[static_cast<std::size_t>(i)], response(net, solution.v, i));
      solution.residual = std::max(solution.residual, error);
      if (error > 0.9 * tolerance) active.push_back(i);
    }
  }
}

NeuralSolution solve_active_list(const NeuralNet& net, const NeuralMapOptions& options, const Work& work) {
  NeuralSolution solution{.v = resting(net)};
  std::vector<std::int32_t> active;
  for (const std::int32_t target : net.targets)
    net.for_each_link(target, [&](std::int32_t j, int) { active.push_back(j); });
  settle(net, solution, std::move(active), options.tolerance, work);
  return solution;
}

}  // namespace meander
