// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "topology/net_options.hpp"

namespace meander::topology {

/// A ring of sensors seen from another bearing: out[i] is what `ring` tells at bearing i * pitch + turn, linear between
/// two sensors. Same sizes.
void turn_ring(std::span<const float> ring, double turn, std::span<float> out);

/// Smooths binary contacts along the ring by a Gaussian whose weights add up to 1 ([Z] section 3-1).
class TouchSmoother {
 public:
  /// `sigma` [rad].
  TouchSmoother(int sensors, double sigma);
  void smooth(std::span<const std::uint8_t> bent, std::span<float> out) const;

 private:
  std::vector<float> kernel_;  ///< by distance along the ring, one whole turn
};

/// What the distance of two rows of senses counts: a weight for every value. Rows are padded with zeros to multiples of
/// kSenseLanes.
inline constexpr int kSenseLanes = 8;
class SenseMetric {
 public:
  SenseMetric() = default;
  /// `touch` values first, then `light` values; either may be 0.
  SenseMetric(int touch, int light, const Scales& scales);
  int touch() const { return touch_; }
  int light() const { return light_; }
  int stride() const { return static_cast<int>(weight_.size()); }
  /// sum_k weight_k (a_k - b_k)^2 in a fixed order.
  double squared(const float* a, const float* b) const;

 private:
  int touch_ = 0, light_ = 0;
  std::vector<float> weight_;
};

}  // namespace meander::topology
