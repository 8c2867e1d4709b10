// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>

#include "base/fields.hpp"
#include "base/work.hpp"
#include "mapping/network.hpp"

namespace meander {

/// What a network is to learn: a row of inputs and the wanted probability for each example.
struct Examples {
  int inputs = 0;
  std::vector<float> rows;
  std::vector<float> wanted;  ///< 1: occupied, 0: free, 0.5: nobody can know

  std::size_t size() const { return wanted.size(); }
  std::span<const float> row(std::size_t i) const {
    const auto width = static_cast<std::size_t>(inputs);
    return std::span(rows).subspan(i * width, width);
  }
};

enum class TrainingMethod { adam, backprop };
template <>
struct EnumNames<TrainingMethod> {
  static constexpr std::pair<TrainingMethod, const char*> entries[] = {{TrainingMethod::adam, "adam"},
                                                                       {TrainingMethod::backprop, "backprop"}};
};

struct TrainingOptions {
  TrainingMethod method = TrainingMethod::adam;
  std::vector<int> hidden{16, 16};
  int epochs = 40;
  int batch = 256;
  double rate = 0;
  double momentum = 0.9;
  bool balanced = true;
  double unknown = 0.25;
  std::uint64_t seed = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TrainingOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"method", "", "adam: cross-entropy; backprop: the paper's, squared error down the gradient"}, o.method);
  visit(Field{"hidden", "", "units of each hidden layer"}, o.hidden);
  visit(Field{"epochs", "", "times that every example is seen", 1, 100000}, o.epochs);
  visit(Field{"batch", "", "examples to a step", 1, 1e6}, o.batch);
  visit(Field{"rate", "", "of learning; 0: 0.02 for adam, 0.3 for backprop", 0, 10}, o.rate);
  visit(Field{"momentum", "", "backprop: share of the last step that is taken again", 0, 0.999}, o.momentum);
  visit(Field{"balanced", "", "occupied and free examples weigh the same, however many there are"}, o.balanced);
  visit(Field{"unknown", "", "weight of hidden examples, against that of all others together", 0, 10}, o.unknown);
  visit(Field{"seed", "", "of the first weights and of the order of the examples"}, o.seed);
}

/// How far the training is. Losses are class-balanced cross-entropies of what is seen [nats]; a coin has 0.693.
struct TrainingEpoch {
  int epoch = 0;  ///< 1 first
  int epochs = 0;
  double training = 0;    ///< mean over the epoch, while the weights changed
  double validation = 0;  ///< after it; 0 without validation examples
};

/// Trains a network from random weights. The same examples and options give the same bits. Throws ArgumentError when
/// one of the two classes is missing.
Network train_network(const Examples& training, const Examples& validation, const TrainingOptions& options,
                      const Work& work = {}, const std::function<void(const TrainingEpoch&)>& on_epoch = {});

/// What the outputs of a network that learns so are above what single scans tell: the log-odds of the base rate of
/// occupied cells, [CN] eq. (3); 0 when both classes weigh the same.
double learnt_prior(const Examples& training, const TrainingOptions& options);

/// How well a network tells occupied from free, both classes weighing the same; hidden examples do not count.
struct NetworkScore {
  double cross_entropy = 0;  ///< [nats]
  double brier = 0;          ///< mean squared error of the probability
  double auc = 0;            ///< probability that an occupied cell gets more than a free one
};
/// `prior` is what the outputs are to be lowered by (log-odds).
NetworkScore network_score(const Network& network, const Examples& examples, double prior = 0);

}  // namespace meander
