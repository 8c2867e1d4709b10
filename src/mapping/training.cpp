// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/training.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "mapping/log_odds.hpp"
#include "mapping/network_score.hpp"

namespace meander {
namespace {

using mapping::Block, mapping::kBlock, mapping::kLanes, mapping::Lanes, mapping::NetworkPass;

void check(const Examples& training, const Examples& validation, const TrainingOptions& options) {
  validate(options);
  const ClassCounts counts = class_counts(training);
  if (counts.occupied == 0 || counts.free == 0)
    fail("training: examples of occupied and of free cells expected, got {} and {}", counts.occupied, counts.free);
  if (validation.size() > 0 && validation.inputs != training.inputs)
    fail("training: {} inputs as in the training examples expected, got {}", training.inputs, validation.inputs);
}

std::vector<int> layers_of(const Examples& training, const TrainingOptions& options) {
  std::vector<int> layers{training.inputs};
  layers.insert(layers.end(), options.hidden.begin(), options.hidden.end());
  layers.push_back(1);
  return layers;
}

/// Turns gradients into steps.
class Descent {
 public:
  Descent(const TrainingOptions& options, std::size_t weights)
      : adam_(options.method == TrainingMethod::adam),
        rate_(options.rate > 0 ? options.rate
              : adam_          ? 0.02
                               : 0.3),
        momentum_(options.momentum),
        mean_(weights),
        square_(adam_ ? weights : 0) {}

  /// `progress` in [0, 1): Adam's rate falls with the cosine to 0.
  void step(std::span<float> weights, std::span<const float> gradient, double progress) {
    if (adam_)
      step_adam(weights, gradient, progress);
    else
      step_plain(weights, gradient);
  }

 private:
  /// Kingma and Ba: Adam, a method for stochastic optimization (ICLR 2015), algorithm 1.
  void step_adam(std::span<float> weights, std::span<const float> gradient, double progress) {
    constexpr double kMean = 0.9, kSquare = 0.999, kLeast = 1e-8;
    mean_power_ *= kMean;
    square_power_ *= kSquare;
    const double rate = rate_ * 0.5 * (1 + sin_cos(kPi * progress).cos) / (1 - mean_power_);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double g = gradient[i];
      mean_[i] = kMean * mean_[i] + (1 - kMean) * g;
      square_[i] = kSquare * square_[i] + (1 - kSquare) * g * g;
      weights[i] -= static_cast<float>(rate * mean_[i] / (std::sqrt(square_[i] / (1 - square_power_)) + kLeast));
    }
  }
  /// [CN] 2.1: back-propagation, with momentum.
  void step_plain(std::span<float> weights, std::span<const float> gradient) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
      mean_[i] = momentum_ * mean_[i] - rate_ * gradient[i];
      weights[i] += static_cast<float>(mean_[i]);
    }
  }

  bool adam_;
  double rate_;
  double momentum_;
  double mean_power_ = 1, square_power_ = 1;
  std::vector<double> mean_, square_;
};

/// How much each example counts; 1 on average over those that are seen.
std::vector<float> example_weights(const Examples& examples, const TrainingOptions& options) {
  const ClassCounts counts = class_counts(examples);
  const double seen = counts.occupied + counts.free;
  const double occupied = options.balanced ? seen / (2 * counts.occupied) : 1;
  const double free = options.balanced ? seen / (2 * counts.free) : 1;
  const double unknown = options.unknown * seen / std::max(1.0, counts.hidden);
  std::vector<float> weights;
  weights.reserve(examples.size());
  for (const float wanted : examples.wanted)
    weights.push_back(static_cast<float>(wanted > 0.5F ? occupied : wanted < 0.5F ? free : unknown));
  return weights;
}

/// Takes one block of examples through the network and back.
class Learner {
 public:
  Learner(const Examples& examples, const TrainingOptions& options, const Network& network)
      : pass(network),
        examples_(examples),
        squared_(options.method == TrainingMethod::backprop),
        weights_(example_weights(examples, options)),
        losses_(class_counts(examples)),
        prior_(static_cast<float>(learnt_prior(examples, options))),
        base_rate_(probability_of(prior_)) {}

  /// `order` names up to kBlock examples; `share`: of each in the step.
  void learn(std::span<const std::uint32_t> order, float share) {
    const Block& output = load(order);
    Block error{};
    for (std::size_t p = 0; p < error.size(); ++p) {
      const Lanes y = mapping::logistic(output[p]);
      // by the output: of the cross-entropy; of half the squared error
      error[p] = squared_ ? (y - wanted_[p]) * y * (1.0F - y) : y - wanted_[p];
      error[p] *= counted_[p] * share;
    }
    pass.backward(error);
    for (std::size_t i = 0; i < order.size(); ++i)
      losses_.add(output[i / kLanes][i % kLanes] - prior_, examples_.wanted[order[i]]);
  }
  double mean_loss() { return losses_.take(); }

  NetworkPass pass;

 private:
  const Block& load(std::span<const std::uint32_t> order) {
    const std::span<Block> inputs = pass.inputs();
    for (std::size_t i = 0; i < static_cast<std::size_t>(kBlock); ++i) {
      const bool real = i < order.size();
      const std::uint32_t example = order[real ? i : 0];
      const std::span<const float> row = examples_.row(example);
      for (std::size_t k = 0; k < row.size(); ++k) inputs[k][i / kLanes][i % kLanes] = row[k];
      // Of what nobody can see the base rate is known, which is taken off again.
      const float wanted = examples_.wanted[example];
      wanted_[i / kLanes][i % kLanes] = wanted == 0.5F ? base_rate_ : wanted;
      counted_[i / kLanes][i % kLanes] = real ? weights_[example] : 0.0F;
    }
    return pass.forward();
  }

  const Examples& examples_;
  bool squared_;
  std::vector<float> weights_;
  BalancedLoss losses_;
  float prior_, base_rate_;
  Block wanted_{}, counted_{};
};

void shuffle(std::vector<std::uint32_t>& order, Stream& stream) {
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(stream.below(static_cast<int>(i)))]);
}

}  // namespace

double learnt_prior(const Examples& training, const TrainingOptions& options) {
  const ClassCounts counts = class_counts(training);
  return options.balanced ? 0 : logarithm(counts.occupied / counts.free);
}

Network train_network(const Examples& training, const Examples& validation, const TrainingOptions& options,
                      const Work& work, const std::function<void(const TrainingEpoch&)>& on_epoch) {
  check(training, validation, options);
  Network network = random_network(layers_of(training, options), options.seed);
  const double prior = learnt_prior(training, options);
  Learner learner(training, options, network);
  Descent descent(options, network.weights.size());
  Stream stream(options.seed, "network.order");
  std::vector<std::uint32_t> order(training.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<float> gradient(network.weights.size());
  const auto batch = static_cast<std::size_t>(options.batch);
  for (int epoch = 0; epoch < options.epochs; ++epoch) {
    shuffle(order, stream);
    for (std::size_t begin = 0; begin < order.size(); begin += batch) {
      work.poll();
      const std::span<const std::uint32_t> step =
          std::span(order).subspan(begin, std::min(batch, order.size() - begin));
      for (std::size_t i = 0; i < step.size(); i += kBlock)
        learner.learn(step.subspan(i, std::min<std::size_t>(kBlock, step.size() - i)),
                      1.0F / static_cast<float>(step.size()));
      learner.pass.take_gradient(gradient);
      descent.step(learner.pass.weights(), gradient,
                   (epoch + static_cast<double>(begin) / static_cast<double>(order.size())) / options.epochs);
    }
    const std::span<const float> weights = learner.pass.weights();
    network.weights.assign(weights.begin(), weights.end());
    const double loss = learner.mean_loss();
    if (on_epoch)
      on_epoch({epoch + 1, options.epochs, loss,
                validation.size() > 0 ? balanced_loss(network, validation, prior, work) : 0});
    work.report((epoch + 1.0) / options.epochs, "training");
  }
  return network;
}

}  // namespace meander
