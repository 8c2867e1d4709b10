// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/network_score.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// Share of pairs (occupied, free) in which the occupied one has more; ties count half.
double area_under_curve(std::vector<std::pair<float, bool>> outputs, const ClassCounts& counts) {
  std::sort(outputs.begin(), outputs.end());
  double pairs = 0, free_below = 0;
  for (std::size_t i = 0; i < outputs.size();) {
    std::size_t end = i;
    double occupied = 0, free = 0;
    for (; end < outputs.size() && outputs[end].first == outputs[i].first; ++end)
      (outputs[end].second ? occupied : free) += 1;
    pairs += occupied * (free_below + 0.5 * free);
    free_below += free;
    i = end;
  }
  return pairs / (counts.occupied * counts.free);
}

}  // namespace

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

std::vector<float> network_outputs(const Network& network, const Examples& examples) {
  using mapping::kBlock, mapping::kLanes;
  mapping::NetworkPass pass(network);
  if (examples.inputs != network.layers.front())
    fail("network: {} inputs expected, got {}", network.layers.front(), examples.inputs);
  std::vector<float> outputs(examples.size());
  for (std::size_t begin = 0; begin < examples.size(); begin += kBlock) {
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

NetworkScore score_of(std::span<const float> log_odds, const Examples& examples) {
  const ClassCounts counts = class_counts(examples);
  if (counts.occupied == 0 || counts.free == 0)
    fail("score: examples of occupied and of free cells expected, got {} and {}", counts.occupied, counts.free);
  BalancedLoss loss(counts);
  double occupied = 0, free = 0;
  std::vector<std::pair<float, bool>> seen;
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
          .auc = area_under_curve(std::move(seen), counts)};
}

NetworkScore network_score(const Network& network, const Examples& examples, double prior) {
  std::vector<float> outputs = network_outputs(network, examples);
  for (float& output : outputs) output -= static_cast<float>(prior);
  return score_of(outputs, examples);
}

}  // namespace meander
