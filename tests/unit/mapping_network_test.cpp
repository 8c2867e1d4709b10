// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.hpp"
#include "base/random.hpp"
#include "mapping/network_score.hpp"

namespace meander {
namespace {

using mapping::kBlock, mapping::kLanes, mapping::NetworkPass;

void fill(NetworkPass& pass, Stream& random) {
  for (mapping::Block& block : pass.inputs())
    for (auto& part : block)
      for (int i = 0; i < kLanes; ++i) part[i] = static_cast<float>(random.uniform(-1, 1));
}

/// Points of the plane; inside of a ring is occupied, some are hidden.
Examples ring_examples(std::uint64_t seed, int count) {
  Stream random(seed, "examples");
  Examples examples{2, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), r = std::sqrt(x * x + y * y);
    examples.rows.push_back(static_cast<float>(x));
    examples.rows.push_back(static_cast<float>(y));
    examples.wanted.push_back(random.chance(0.05) ? 0.5F : r > 0.4 && r < 0.6 ? 1.0F : 0.0F);
  }
  return examples;
}

std::uint64_t hash_of(const Network& network) {
  Hash hash;
  for (const float weight : network.weights) hash.add(static_cast<double>(weight));
  return hash.value();
}

TEST(Network, IsTheFormulaOfThePaper) {
  Stream random(1, "network");
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<int> layers{1 + random.below(9)};
    for (int l = random.below(3); l > 0; --l) layers.push_back(1 + random.below(20));
    layers.push_back(1);
    const Network network = random_network(layers, static_cast<std::uint64_t>(trial));
    NetworkPass pass(network);
    fill(pass, random);
    const float output = pass.forward()[3][2];
    std::vector<double> values;
    for (const mapping::Block& block : pass.inputs()) values.push_back(block[3][2]);
    std::size_t w = 0;
    for (std::size_t l = 1; l < layers.size(); ++l) {
      std::vector<double> next;
      for (int unit = 0; unit < layers[l]; ++unit) {
        double sum = 0;
        for (const double value : values) sum += network.weights[w++] * value;
        sum += network.weights[w++];
        next.push_back(l + 1 < layers.size() ? std::tanh(sum) : sum);
      }
      values = next;
    }
    EXPECT_NEAR(output, values[0], 3e-4) << "trial " << trial;
  }
}

TEST(Network, GradientIsThatOfNumericDifferences) {
  Stream random(2, "gradient");
  for (const std::vector<int>& layers : {std::vector{3, 1}, {4, 5, 1}, {5, 16, 16, 1}, {8, 7, 3, 2, 1}}) {
    const Network network = random_network(layers, 3);
    NetworkPass pass(network);
    fill(pass, random);
    mapping::Block slopes{};  // the error is the sum of slope * output
    for (auto& part : slopes)
      for (int i = 0; i < kLanes; ++i) part[i] = static_cast<float>(random.uniform(-1, 1));
    const auto error = [&] {
      double total = 0;
      const mapping::Block& output = pass.forward();
      for (std::size_t p = 0; p < output.size(); ++p)
        for (int i = 0; i < kLanes; ++i) total += static_cast<double>(slopes[p][i]) * output[p][i];
      return total;
    };
    error();
    pass.backward(slopes);
    std::vector<float> gradient(network.weights.size());
    pass.take_gradient(gradient);
    for (std::size_t w = 0; w < gradient.size(); ++w) {
      constexpr float kStep = 5e-3F;
      const float before = pass.weights()[w];
      pass.weights()[w] = before + kStep;
      const double above = error();
      pass.weights()[w] = before - kStep;
      const double below = error();
      pass.weights()[w] = before;
      EXPECT_NEAR(gradient[w], (above - below) / (2 * kStep), 5e-3 + 2e-3 * std::abs(gradient[w]))
          << layers.size() << " layers, weight " << w;
    }
  }
}

TEST(Network, BadShapesAreRefused) {
  EXPECT_THROW(random_network({3}, 1), ArgumentError);
  EXPECT_THROW(random_network({3, 0, 1}, 1), ArgumentError);
  EXPECT_THROW(random_network({3, 2}, 1), ArgumentError);
  EXPECT_THROW(random_network({3, 100000, 1}, 1), ArgumentError);
  EXPECT_THROW(random_network(std::vector<int>(20, 1), 1), ArgumentError);
  EXPECT_THROW(NetworkPass(Network{{3, 1}, {1, 2}}), ArgumentError);
}

TEST(Training, BothMethodsLearnARing) {
  const Examples training = ring_examples(1, 4000), validation = ring_examples(2, 2000);
  TrainingOptions options{.hidden = {16, 16}, .epochs = 60, .batch = 64};
  const NetworkScore adam = network_score(train_network(training, validation, options), validation);
  EXPECT_LT(adam.cross_entropy, 0.2);
  EXPECT_GT(adam.auc, 0.97);
  options.method = TrainingMethod::backprop;
  const NetworkScore plain = network_score(train_network(training, validation, options), validation);
  EXPECT_LT(plain.cross_entropy, 0.5);
  EXPECT_GT(plain.auc, 0.85);
}

TEST(Training, RareClassesNeedBalance) {
  const Examples training = ring_examples(3, 4000), validation = ring_examples(4, 2000);
  TrainingOptions options{.hidden = {12}, .epochs = 20, .batch = 64};
  const double balanced = network_score(train_network(training, {}, options), validation).cross_entropy;
  options.balanced = false;
  const Network natural = train_network(training, {}, options);
  const ClassCounts counts = class_counts(training);
  const double prior = std::log(counts.occupied / counts.free);
  EXPECT_LT(balanced, network_score(natural, validation).cross_entropy);
  EXPECT_LT(network_score(natural, validation, prior).cross_entropy, network_score(natural, validation).cross_entropy);
}

TEST(Training, NaturalSharesLeaveHiddenCellsUnknown) {
  // Left of 0 one cell in 25 is occupied, right of it nobody can see.
  Stream random(10, "hidden");
  Examples examples{1, {}, {}};
  for (int i = 0; i < 5000; ++i) {
    const double x = random.uniform(-1, 1);
    examples.rows.push_back(static_cast<float>(x));
    examples.wanted.push_back(x > 0 ? 0.5F : random.chance(0.04) ? 1.0F : 0.0F);
  }
  for (const bool balanced : {true, false})
    for (const double unknown : {0.25, 2.0}) {
      const TrainingOptions options{.hidden = {8}, .epochs = 20, .batch = 64, .balanced = balanced, .unknown = unknown};
      const double prior = learnt_prior(examples, options);
      EXPECT_EQ(prior == 0, balanced);
      const std::vector<float> outputs = network_outputs(train_network(examples, {}, options), examples);
      for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (std::abs(examples.rows[i]) < 0.2F) continue;
        ASSERT_NEAR(outputs[i] - prior, 0, 0.7) << examples.rows[i];
      }
    }
}

TEST(Training, LossesOfNaturalSharesAreWithoutTheBaseRate) {
  const Examples training = ring_examples(3, 4000), validation = ring_examples(4, 2000);
  const TrainingOptions options{.hidden = {12}, .epochs = 20, .batch = 64, .balanced = false};
  TrainingEpoch last;
  const Network network =
      train_network(training, validation, options, {}, [&](const TrainingEpoch& epoch) { last = epoch; });
  EXPECT_EQ(last.validation, network_score(network, validation, learnt_prior(training, options)).cross_entropy);
  EXPECT_NEAR(last.training, last.validation, 0.1);
}

/// The same bits in every build: this is compared by the builds with and without optimisation and with sanitizers.
TEST(Training, SameSeedSameBits) {
  const Examples training = ring_examples(5, 777);
  TrainingOptions options{.hidden = {5, 4}, .epochs = 6, .batch = 100};
  const Network network = train_network(training, {}, options);
  EXPECT_EQ(hash_of(network), hash_of(train_network(training, ring_examples(6, 10), options)));
  EXPECT_EQ(hash_of(network), 2759103134668738647u);
  options.seed = 2;
  EXPECT_NE(hash_of(network), hash_of(train_network(training, {}, options)));
}

TEST(Training, TellsHowItGoesAndStops) {
  const Examples training = ring_examples(7, 500);
  std::vector<TrainingEpoch> epochs;
  train_network(training, training, {.hidden = {4}, .epochs = 5}, {},
                [&](const TrainingEpoch& epoch) { epochs.push_back(epoch); });
  ASSERT_EQ(epochs.size(), 5u);
  EXPECT_EQ(epochs.back().epoch, 5);
  EXPECT_LT(epochs.back().validation, epochs.front().training);
  StopToken stop;
  const Work work{.stop = &stop, .progress = {}};
  EXPECT_THROW(train_network(training, {}, {.epochs = 1000}, work, [&](const TrainingEpoch&) { stop.request(); }),
               Cancelled);
}

TEST(Training, OneClassAloneIsRefused) {
  Examples training = ring_examples(8, 100);
  for (float& wanted : training.wanted) wanted = 0;
  EXPECT_THROW(train_network(training, {}, {}), ArgumentError);
  EXPECT_THROW(train_network({}, {}, {}), ArgumentError);
}

TEST(Score, AreaIsTheShareOfPairs) {
  Stream random(9, "auc");
  const Examples examples = ring_examples(9, 300);
  std::vector<float> outputs;
  for (std::size_t i = 0; i < examples.size(); ++i)
    outputs.push_back(static_cast<float>(random.below(10)) + examples.wanted[i]);
  double pairs = 0, right = 0;
  for (std::size_t i = 0; i < outputs.size(); ++i)
    for (std::size_t j = 0; j < outputs.size(); ++j)
      if (examples.wanted[i] == 1 && examples.wanted[j] == 0) {
        pairs += 1;
        right += outputs[i] > outputs[j] ? 1 : outputs[i] == outputs[j] ? 0.5 : 0;
      }
  EXPECT_DOUBLE_EQ(score_of(outputs, examples).auc, right / pairs);
  StopToken stop;
  stop.request();
  EXPECT_THROW(balanced_loss(random_network({2, 3, 1}, 1), examples, 0, {.stop = &stop, .progress = {}}), Cancelled);
}

}  // namespace
}  // namespace meander
