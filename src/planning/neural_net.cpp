// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_net.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

// [LM99] w_ij = f(rho(c_i, c_j))
double weight_law(const NeuralMapOptions& options, double cost) {
  constexpr double kDearest = 60;  // a way is dear, never closed
  return options.weights == WeightLaw::inverse ? 1 / cost
                                               : falling_exponential(std::min(options.gamma * cost * cost, kDearest));
}

std::int32_t offset_of(const NeuralNet& net, int dx, int dy) { return dy * net.stride + dx; }

void set_steps(NeuralNet& net, const PlanningProblem& problem, const NeuralMapOptions& options) {
  for (int row = 0; row < 2; ++row) {
    const std::span<const LatticeStep> steps = lattice_steps(problem.lattice, row);
    net.steps = static_cast<int>(steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      net.offset[static_cast<std::size_t>(row)][k] = offset_of(net, steps[k].dx, steps[k].dy);
      net.weight[k] = weight_law(options, steps[k].length);
    }
  }
}

/// The steps that are open from each free unit. [LM99+] Steps longer than a diagonal do not jump over walls.
void set_links(NeuralNet& net, const PlanningProblem& problem, const Work& work) {
  std::vector<std::uint8_t> blocked(net.links.size(), 1);
  for (int y = 0; y < net.height; ++y)
    for (int x = 0; x < net.width; ++x) blocked[static_cast<std::size_t>(net.index({x, y}))] = problem.blocked[{x, y}];
  const auto is_blocked = [&](std::int32_t i) { return blocked[static_cast<std::size_t>(i)] != 0; };
  for (int y = 0; y < net.height; ++y) {
    work.poll();
    const std::span<const LatticeStep> steps = lattice_steps(problem.lattice, y);
    for (int x = 0; x < net.width; ++x) {
      const std::int32_t i = net.index({x, y});
      if (is_blocked(i)) continue;
      std::uint32_t mask = (y & 1) != 0 ? NeuralNet::kOddRow : 0;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const LatticeStep& step = steps[k];
        bool open = !is_blocked(i + offset_of(net, step.dx, step.dy));
        if (!step.diagonal || problem.corners == Corners::keep)
          for (int via = 0; via < step.vias; ++via)
            open = open && !is_blocked(i + offset_of(net, step.via[via].x, step.via[via].y));
        if (open) mask |= 1u << k;
      }
      net.links[static_cast<std::size_t>(i)] = mask;
    }
  }
}

/// Weights that differ from unit to unit: those of hard ways are small. Returns the largest sum of a unit.
double set_weights(NeuralNet& net, const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work) {
  net.weights.assign(net.links.size() * static_cast<std::size_t>(net.steps), 0);
  double most = 0;
  for (int y = 0; y < net.height; ++y) {
    work.poll();
    for (int x = 0; x < net.width; ++x) {
      const std::int32_t i = net.index({x, y});
      double sum = 0;
      net.for_each_link(i, [&](std::int32_t, int k) {
        const LatticeStep& step = lattice_steps(problem.lattice, y)[static_cast<std::size_t>(k)];
        float& w = net.weights[static_cast<std::size_t>(i * net.steps + k)];
        w = static_cast<float>(weight_law(options, step_cost(problem, {x, y}, step)));
        sum += static_cast<double>(w);
      });
      most = std::max(most, sum);
    }
  }
  return most;
}

}  // namespace

NeuralNet neural_net(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work) {
  NeuralNet net;
  net.lattice = problem.lattice;
  net.width = problem.blocked.width();
  net.height = problem.blocked.height();
  net.stride = net.width + 2 * NeuralNet::kRim;
  const std::size_t units =
      static_cast<std::size_t>(net.stride) * static_cast<std::size_t>(net.height + 2 * NeuralNet::kRim);
  if (units > (std::size_t{1} << 31) / 20) fail("map: at most 10^8 cells expected, got {} x {}", net.width, net.height);
  net.links.assign(units, 0);
  net.steepness = options.steepness;
  set_steps(net, problem, options);
  set_links(net, problem, work);
  double most = 0;  // [LM99+] the largest sum of weights bounds the paper's lambda, and no unit outdoes its neighbours
  if (problem.even())
    for (int k = 0; k < net.steps; ++k) most += net.weight[static_cast<std::size_t>(k)];
  else
    most = set_weights(net, problem, options, work);
  net.beta = most > 0 ? options.steepness / most : 0;
  for (double& w : net.weight) w *= net.beta;
  for (const Cell target : free_targets(problem)) {
    net.targets.push_back(net.index(target));
    net.links[static_cast<std::size_t>(net.index(target))] |= NeuralNet::kTarget;
  }
  return net;
}

void relink(NeuralNet& net, const PlanningProblem& problem, Cell cell) {
  std::uint32_t& links = net.links[static_cast<std::size_t>(net.index(cell))];
  links &= NeuralNet::kTarget;
  if (problem.blocked[cell] != 0) return;
  links |= (cell.y & 1) != 0 ? NeuralNet::kOddRow : 0;
  const std::span<const LatticeStep> steps = lattice_steps(problem.lattice, cell.y);
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (open_step(problem.blocked, problem.corners, cell, steps[k])) links |= 1u << k;
}

Activation resting(const NeuralNet& net) {
  Activation v(net.links.size());
  for (const std::int32_t target : net.targets) v[static_cast<std::size_t>(target)] = {1, 0};
  return v;
}

double relative_error(const Extended& v, const Extended& u) {
  if (u.zero()) return v.zero() ? 0 : std::numeric_limits<double>::infinity();
  return std::abs(v.in_block(u.block) / u.value - 1);
}

}  // namespace meander
