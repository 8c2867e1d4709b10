// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "mapping/training.hpp"

namespace meander {

/// How many examples there are of each kind.
struct ClassCounts {
  double occupied = 0, free = 0, hidden = 0;
};
ClassCounts class_counts(const Examples& examples);
/// The same; throws ArgumentError when there are none occupied or none free.
ClassCounts counts_of_both(const Examples& examples);

/// ln(1 + exp(-z)) where the cell is occupied, ln(1 + exp(z)) where it is free: how much log-odds z surprise [nats].
double surprise(double z, bool occupied);

/// Mean surprise of occupied and of free examples, each class weighing one half. For people: decides nothing.
class BalancedLoss {
 public:
  explicit BalancedLoss(const ClassCounts& counts) : counts_(counts) {}
  void add(double z, float wanted) {
    if (wanted > 0.5F) occupied_ += surprise(z, true);
    if (wanted < 0.5F) free_ += surprise(z, false);
  }
  /// Begins anew.
  double take() {
    const double loss = 0.5 * (occupied_ / counts_.occupied + free_ / counts_.free);
    occupied_ = free_ = 0;
    return loss;
  }

 private:
  ClassCounts counts_;
  double occupied_ = 0, free_ = 0;
};

/// The outputs for all examples.
std::vector<float> network_outputs(const Network& network, const Examples& examples, const Work& work = {});
/// The mean loss of its outputs less the prior. Throws ArgumentError when one of the two classes is missing.
double balanced_loss(const Network& network, const Examples& examples, double prior, const Work& work = {});
/// Of any model's log-odds for these examples. Throws ArgumentError when one of the two classes is missing.
NetworkScore score_of(std::span<const float> log_odds, const Examples& examples);

}  // namespace meander
