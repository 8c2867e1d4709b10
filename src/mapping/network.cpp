// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/network.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/random.hpp"

namespace meander {

void check_layers(std::span<const int> layers) {
  const auto count = static_cast<int>(layers.size());
  if (count < 2 || count > kMostLayers) fail("2 to {} layers expected, got {}", kMostLayers, count);
  for (const int units : layers)
    if (units < 1 || units > kMostUnits) fail("1 to {} units in a layer expected, got {}", kMostUnits, units);
  if (layers.back() != 1) fail("one unit in the last layer expected, got {}", layers.back());
}

std::size_t weight_count(std::span<const int> layers) {
  std::size_t count = 0;
  for (std::size_t l = 1; l < layers.size(); ++l) count += static_cast<std::size_t>((layers[l - 1] + 1) * layers[l]);
  return count;
}

Network random_network(std::vector<int> layers, std::uint64_t seed) {
  check_layers(layers);
  Stream stream(seed, "network.weights");
  Network network{std::move(layers), {}};
  for (std::size_t l = 1; l < network.layers.size(); ++l) {
    const int inputs = network.layers[l - 1];
    for (int unit = 0; unit < network.layers[l]; ++unit) {
      for (int i = 0; i < inputs; ++i)
        network.weights.push_back(static_cast<float>(stream.normal() / std::sqrt(static_cast<double>(inputs))));
      network.weights.push_back(static_cast<float>(0.5 * stream.normal()));
    }
  }
  return network;
}

namespace mapping {
namespace {

constexpr std::size_t kParts = kBlock / kLanes;
constexpr std::size_t kStrip = 4;  ///< registers of cells that are summed at once, for two units

/// A matrix of weights as it lies in memory: forward it is a row per unit, backward a column.
struct Weights {
  const float* first;
  std::size_t per_unit;
  std::size_t per_input;
  float at(std::size_t unit, std::size_t input) const { return first[unit * per_unit + input * per_input]; }
};

/// sums[u][p] += weight(unit + u, i) * inputs[i][p] over all inputs, in their order.
template <std::size_t Units>
[[gnu::always_inline]] inline void add_products(const Weights& weights, std::size_t unit, std::size_t inputs,
                                                const Block* input, std::size_t part, Lanes (&sums)[Units][kStrip]) {
  for (std::size_t i = 0; i < inputs; ++i) {
    Lanes x[kStrip];
#pragma GCC unroll 4
    for (std::size_t p = 0; p < kStrip; ++p) x[p] = input[i][part + p];
#pragma GCC unroll 2
    for (std::size_t u = 0; u < Units; ++u) {
      const Lanes w = all(weights.at(unit + u, i));
#pragma GCC unroll 4
      for (std::size_t p = 0; p < kStrip; ++p) sums[u][p] += w * x[p];
    }
  }
}

/// Weighted sums of units unit .. unit + Units - 1; they begin at `bias` (0 where there is none).
template <std::size_t Units>
void weighted_sums(const Weights& weights, const float* bias, std::size_t unit, std::size_t inputs, const Block* input,
                   Block* output) {
  for (std::size_t part = 0; part < kParts; part += kStrip) {
    Lanes sums[Units][kStrip];
    for (std::size_t u = 0; u < Units; ++u)
      for (Lanes& sum : sums[u]) sum = all(bias ? bias[(unit + u) * weights.per_unit] : 0.0F);
    add_products(weights, unit, inputs, input, part, sums);
    for (std::size_t u = 0; u < Units; ++u)
      for (std::size_t p = 0; p < kStrip; ++p) output[unit + u][part + p] = sums[u][p];
  }
}

void all_weighted_sums(const Weights& weights, const float* bias, std::size_t units, std::size_t inputs,
                       const Block* input, Block* output) {
  std::size_t unit = 0;
  for (; unit + 2 <= units; unit += 2) weighted_sums<2>(weights, bias, unit, inputs, input, output);
  if (unit < units) weighted_sums<1>(weights, bias, unit, inputs, input, output);
}

/// Adds error * input, summed over the block, to the gradients of `count` weights of one unit.
void add_gradient(const Block& error, const Block* input, std::size_t count, Lanes* gradient) {
  for (std::size_t i = 0; i < count; ++i) {
    Lanes even = Lanes{}, odd = Lanes{};
    for (std::size_t p = 0; p < kParts; p += 2) {
      even += error[p] * input[i][p];
      odd += error[p + 1] * input[i][p + 1];
    }
    gradient[i] += even + odd;
  }
}

void add_bias_gradient(const Block& error, Lanes& gradient) {
  for (const Lanes& part : error) gradient += part;
}

}  // namespace

NetworkPass::NetworkPass(const Network& network) : layers_(network.layers), weights_(network.weights) {
  check_layers(layers_);
  if (weights_.size() != weight_count(layers_))
    fail("{} weights expected, got {}", weight_count(layers_), weights_.size());
  std::size_t units = 0;
  for (const int count : layers_) units += static_cast<std::size_t>(count);
  values_.assign(units, Block{});
}

const Block& NetworkPass::forward() {
  Block* input = values_.data();
  const float* weights = weights_.data();
  for (std::size_t layer = 1; layer < layers_.size(); ++layer) {
    const std::size_t inputs = units(layer - 1), count = units(layer);
    Block* output = input + inputs;
    all_weighted_sums({weights, inputs + 1, 1}, weights + inputs, count, inputs, input, output);
    if (layer + 1 < layers_.size())
      for (std::size_t unit = 0; unit < count; ++unit)
        for (Lanes& value : output[unit]) value = tanh(value);
    weights += (inputs + 1) * count;
    input = output;
  }
  return *input;
}

void NetworkPass::backward(const Block& by_output) {
  if (errors_.empty()) {
    errors_.assign(values_.size(), Block{});
    gradient_.assign(weights_.size(), Lanes{});
  }
  errors_.back() = by_output;
  std::size_t first = values_.size() - 1;  // of the layer
  std::size_t weight = weights_.size();    // after the layer's
  for (std::size_t layer = layers_.size() - 1; layer >= 1; --layer) {
    const std::size_t inputs = units(layer - 1), count = units(layer), below = first - inputs;
    weight -= (inputs + 1) * count;
    for (std::size_t unit = 0; unit < count; ++unit) {
      Lanes* gradient = &gradient_[weight + unit * (inputs + 1)];
      add_gradient(errors_[first + unit], &values_[below], inputs, gradient);
      add_bias_gradient(errors_[first + unit], gradient[inputs]);
    }
    if (layer > 1) {
      all_weighted_sums({&weights_[weight], 1, inputs + 1}, nullptr, inputs, count, &errors_[first], &errors_[below]);
      for (std::size_t i = below; i < first; ++i)  // tanh' = 1 - tanh^2
        for (std::size_t p = 0; p < kParts; ++p) errors_[i][p] *= 1.0F - values_[i][p] * values_[i][p];
    }
    first = below;
  }
}

void NetworkPass::take_gradient(std::span<float> gradient) {
  for (std::size_t i = 0; i < gradient_.size(); ++i) {
    gradient[i] = sum(gradient_[i]);
    gradient_[i] = Lanes{};
  }
}

}  // namespace mapping
}  // namespace meander
