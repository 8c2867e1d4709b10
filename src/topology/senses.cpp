// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/senses.hpp"

#include <cmath>

#include "base/elementary.hpp"
#include "geometry/angle.hpp"

namespace meander::topology {

void turn_ring(std::span<const float> ring, double turn, std::span<float> out) {
  const auto n = static_cast<long>(ring.size());
  if (n == 0) return;
  const double shift = turn / (2 * kPi) * static_cast<double>(n);
  const double whole = std::floor(shift);
  const auto share = static_cast<float>(shift - whole);
  const long first = ((static_cast<long>(whole) % n) + n) % n;
  for (long i = 0; i < n; ++i) {
    const auto a = static_cast<std::size_t>((first + i) % n), b = static_cast<std::size_t>((first + i + 1) % n);
    out[static_cast<std::size_t>(i)] = ring[a] + share * (ring[b] - ring[a]);
  }
}

TouchSmoother::TouchSmoother(int sensors, double sigma) : kernel_(static_cast<std::size_t>(sensors)) {
  const double pitch = 2 * kPi / sensors;
  double sum = 0;
  for (int i = 0; i < sensors; ++i) {
    const double off = wrap_angle(i * pitch) / sigma;
    sum += exponential(-0.5 * off * off);
  }
  for (int i = 0; i < sensors; ++i) {
    const double off = wrap_angle(i * pitch) / sigma;
    kernel_[static_cast<std::size_t>(i)] = static_cast<float>(exponential(-0.5 * off * off) / sum);
  }
}

void TouchSmoother::smooth(std::span<const std::uint8_t> bent, std::span<float> out) const {
  const std::size_t n = bent.size();
  std::fill(out.begin(), out.end(), 0.0f);
  for (std::size_t from = 0; from < n; ++from) {
    if (!bent[from]) continue;
    for (std::size_t i = 0; i < n; ++i) out[(from + i) % n] += kernel_[i];
  }
}

SenseMetric::SenseMetric(int touch, int light, const Scales& scales)
    : touch_(touch),
      light_(light),
      weight_(static_cast<std::size_t>((touch + light + kSenseLanes - 1) / kSenseLanes * kSenseLanes)) {
  for (int i = 0; i < touch + light; ++i) {
    const bool is_touch = i < touch;
    const double scale = is_touch ? scales.touch : scales.light;
    weight_[static_cast<std::size_t>(i)] = static_cast<float>(1 / (scale * scale * (is_touch ? touch : light)));
  }
}

double SenseMetric::squared(const float* a, const float* b) const {
  float lanes[kSenseLanes] = {};
  for (std::size_t k = 0; k < weight_.size(); k += kSenseLanes)
    for (std::size_t i = 0; i < kSenseLanes; ++i) {
      const float gap = a[k + i] - b[k + i];
      lanes[i] += weight_[k + i] * (gap * gap);
    }
  return static_cast<double>((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
         static_cast<double>((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

}  // namespace meander::topology
