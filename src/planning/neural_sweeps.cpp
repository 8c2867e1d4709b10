// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <cmath>

#include "planning/neural_solution.hpp"

namespace meander {
namespace {

/// Counts patterns of updates and says when it is enough.
class Ending {
 public:
  Ending(const NeuralNet& net, const NeuralMapOptions& options, std::optional<Cell> start)
      : early_(options.extent == NeuralExtent::start && start.has_value()),
        start_(start ? net.index(*start) : 0),
        extra_(options.extra_patterns),
        tolerance_(options.tolerance) {}

  /// After a pattern whose largest relative change was `change`.
  bool reached(const Activation& v, double change) {
    if (change <= kShare * tolerance_) return true;
    // [LM99] the test for termination is performed only after the pattern is completed
    return early_ && !v[static_cast<std::size_t>(start_)].zero() && extra_-- == 0;
  }

 private:
  static constexpr double kShare = 0.5;
  bool early_;
  std::int32_t start_;
  int extra_;
  double tolerance_;
};

/// Calls update(i) for the units of the map, rows from below or above, each from left or right.
template <class Update>
void raster(const NeuralNet& net, bool from_left, bool from_below, const Work& work, Update update) {
  for (int row = 0; row < net.height; ++row) {
    work.poll();
    for (int column = 0; column < net.width; ++column) {
      const std::int32_t i =
          net.index({from_left ? column : net.width - 1 - column, from_below ? row : net.height - 1 - row});
      const std::uint32_t mask = net.links[static_cast<std::size_t>(i)];
      if ((mask & NeuralNet::kSteps) != 0 && (mask & NeuralNet::kTarget) == 0) update(i);
    }
  }
}

NeuralSolution ended(const NeuralNet& net, NeuralSolution solution, const NeuralMapOptions& options, const Work& work) {
  solution.residual = scan_residuals(net, solution.v, work, [](std::int32_t, double) {});
  solution.complete = solution.residual <= options.tolerance;
  return solution;
}

}  // namespace

NeuralSolution solve_synchronous(const NeuralNet& net, const NeuralMapOptions& options, std::optional<Cell> start,
                                 const Work& work) {
  NeuralSolution solution{.v = resting(net), .solver = "synchronous"};
  Activation next = solution.v;
  Ending ending(net, options, start);
  for (double change = 1; !ending.reached(solution.v, change);) {
    change = 0;
    raster(net, true, true, work, [&](std::int32_t i) {  // v_i(t + 1) = Phi(sum_j w_ij v_j(t) + theta_i)
      Extended& to = next[static_cast<std::size_t>(i)];
      to = response(net, solution.v, i);
      change = std::max(change, relative_error(solution.v[static_cast<std::size_t>(i)], to));
      ++solution.relaxations;
    });
    solution.v.swap(next);
  }
  return ended(net, std::move(solution), options, work);
}

NeuralSolution solve_raster(const NeuralNet& net, const NeuralMapOptions& options, std::optional<Cell> start,
                            const Work& work) {
  // [LM99] Figure 3: the pattern of four crossing rasters
  constexpr bool kPattern[4][2] = {{true, true}, {false, false}, {false, true}, {true, false}};
  NeuralSolution solution{.v = resting(net), .solver = "raster"};
  Ending ending(net, options, start);
  for (double change = 1; !ending.reached(solution.v, change);) {
    change = 0;
    for (const auto& [from_left, from_below] : kPattern)
      raster(net, from_left, from_below, work, [&](std::int32_t i) {
        Extended& own = solution.v[static_cast<std::size_t>(i)];
        const Extended u = response(net, solution.v, i);
        change = std::max(change, relative_error(own, u));
        own = u;
        ++solution.relaxations;
      });
  }
  return ended(net, std::move(solution), options, work);
}

}  // namespace meander
