// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/network_score.hpp"

#include <algorithm>
#include <cmath>

#include "base/area_under_curve.hpp"

namespace meander {
ClassCounts class_counts(const Examples& examples) {
  ClassCounts counts;
  for (const float wanted : examples.wanted)
    (wanted > 0.5F ? counts.occupied : wanted < 0.5F ? counts.free : counts.hidden) += 1;
  return counts;
}

double surprise(double z, bool occupied) {
  const double against = occupied ? -z : z;
  return std::max(against, 0.0) + std::log1p(std::exp(-std::abs(against)));
}

std::vector<float> network_outputs(const Network& network, const Examples& examples, const Work& work) {
  using mapping::kBlock, mapping::kLanes;
  mapping::NetworkPass pass(network);
  if (examples.inputs != network.layers.front())
    fail("network: {} inputs expected, got {}", network.layers.front(), examples.inputs);
  std::vector<float> outputs(examples.size());
  for (std::size_t begin = 0; begin < examples.size(); begin += kBlock) {
    if (begin % (16 * kBlock) == 0) work.poll();
    const std::size_t count = std::min<std::size_t>(kBlock, examples.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const std::span<const float> row = examples.row(begin + i);
      for (std::size_t k = 0; k < row.size(); ++k) pass.inputs()[k][i / kLanes][i % kLanes] = row[k];
    }
    const mapping::Block& output = pass.forward();
    for (std::size_t i = 0; i < count; ++i) outputs[begin + i] = output[i / kLanes][i % kLanes];
  }
  return outputs;
}

ClassCounts counts_of_both(const Examples& examples) {
  const ClassCounts counts = class_counts(examples);
  if (counts.occupied == 0 || counts.free == 0)
    fail("score: examples of occupied and of free cells expected, got {} and {}", counts.occupied, counts.free);
  return counts;
}

NetworkScore score_of(std::span<const float> log_odds, const Examples& examples) {
  const ClassCounts counts = counts_of_both(examples);
  BalancedLoss loss(counts);
  double occupied = 0, free = 0;
  std::vector<std::pair<double, bool>> seen;
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const float wanted = examples.wanted[i];
    if (wanted == 0.5F) continue;
    loss.add(log_odds[i], wanted);
    const double probability = 1 / (1 + std::exp(-static_cast<double>(log_odds[i])));
    (wanted > 0.5F ? occupied : free) += (probability - wanted) * (probability - wanted);
    seen.emplace_back(log_odds[i], wanted > 0.5F);
  }
  return {.cross_entropy = loss.take(),
          .brier = 0.5 * (occupied / counts.occupied + free / counts.free),
          .auc = area_under_curve(std::move(seen))};
}

NetworkScore network_score(const Network& network, const Examples& examples, double prior) {
  std::vector<float> outputs = network_outputs(network, examples);
  for (float& output : outputs) output -= static_cast<float>(prior);
  return score_of(outputs, examples);
}

double balanced_loss(const Network& network, const Examples& examples, double prior, const Work& work) {
  BalancedLoss loss(counts_of_both(examples));
  const std::vector<float> outputs = network_outputs(network, examples, work);
  for (std::size_t i = 0; i < outputs.size(); ++i) loss.add(outputs[i] - static_cast<float>(prior), examples.wanted[i]);
  return loss.take();
}

}  // namespace meander
