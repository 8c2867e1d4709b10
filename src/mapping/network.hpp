// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mapping/lanes.hpp"

namespace meander {

/// A feed-forward network, [CN] Fig. 2: tanh in the hidden layers; the logistic function of its one output is a
/// probability, so that the output itself is its log-odds.
struct Network {
  std::vector<int> layers;     ///< units of each, the inputs first; the last has one
  std::vector<float> weights;  ///< layer by layer, unit by unit: one for each input, then the bias
};

inline constexpr int kMostLayers = 8;
inline constexpr int kMostUnits = 256;

/// Throws ArgumentError unless there are 2 to kMostLayers layers of 1 to kMostUnits units, the last of one.
void check_layers(std::span<const int> layers);
/// Of valid layers.
std::size_t weight_count(std::span<const int> layers);
/// Weights N(0, 1 / inputs), biases N(0, 0.25).
Network random_network(std::vector<int> layers, std::uint64_t seed);

namespace mapping {

/// As many cells as go through a network at once.
inline constexpr int kBlock = 64;
using Block = std::array<Lanes, kBlock / kLanes>;

/// Takes blocks through a network, and errors back. All sums have a fixed order: the same weights and inputs give the
/// same bits in every build and on every machine. Allocates when it is made.
class NetworkPass {
 public:
  explicit NetworkPass(const Network& network);

  /// To be filled: one block for each input.
  std::span<Block> inputs() { return std::span(values_).first(static_cast<std::size_t>(layers_.front())); }
  /// The output for these inputs.
  const Block& forward();
  /// After forward(): adds the gradient of a sum of errors whose derivatives by the outputs are given.
  void backward(const Block& by_output);
  /// The gradient summed so far, in the order of the weights; begins anew.
  void take_gradient(std::span<float> gradient);

  std::span<float> weights() { return weights_; }
  std::size_t bytes() const {
    return sizeof(float) * weights_.capacity() + sizeof(Block) * (values_.capacity() + errors_.capacity()) +
           sizeof(Lanes) * gradient_.capacity();
  }

 private:
  std::size_t units(std::size_t layer) const { return static_cast<std::size_t>(layers_[layer]); }

  std::vector<int> layers_;
  std::vector<float> weights_;
  std::vector<Block> values_;    ///< outputs of all units, the inputs first
  std::vector<Block> errors_;    ///< derivatives by the sums of all units
  std::vector<Lanes> gradient_;  ///< lane by lane
};

}  // namespace mapping
}  // namespace meander
