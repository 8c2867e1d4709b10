// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_effects.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meander::sonar {
namespace {

/// A spurious echo comes from somewhere between this share of the true range and the true range (docs/sonar.md).
constexpr double kSpuriousLeast = 0.15;

}  // namespace

Effects::Effects(const SonarOptions& options, int count, std::uint64_t seed)
    : options_(options),
      flicker_(seed, "sonar/flicker"),
      noise_(seed, "sonar/noise"),
      outliers_(seed, "sonar/outliers"),
      shift_(count),
      last_(count, std::numeric_limits<double>::quiet_NaN()) {
  if (options_.incidence_jitter > 0)
    for (double& shift : shift_) shift = flicker_.normal();
}

double Effects::limit_shift(int transducer) {
  if (options_.incidence_jitter <= 0) return 0;
  const bool fresh = flicker_.chance(1 / options_.jitter_hold);
  const double shift = flicker_.normal();
  if (fresh) shift_[transducer] = shift;
  return options_.incidence_jitter * shift_[transducer];
}

double Effects::disturbed(double range, double last) {
  if (options_.noise > 0 || options_.noise_proportional > 0) {
    const double sigma = options_.noise + options_.noise_proportional * range;
    const double error = sigma * noise_.normal();
    if (range < options_.range_max) range += error;  // silence has no noise
  }
  if (options_.dropout > 0 || options_.spurious > 0 || options_.repeat > 0) {
    const bool spurious = outliers_.chance(options_.spurious);
    const double share = outliers_.uniform(kSpuriousLeast, 1);
    const bool dropout = outliers_.chance(options_.dropout);
    const bool repeat = outliers_.chance(options_.repeat);
    if (spurious) range *= share;
    if (dropout) range = options_.range_max;
    if (repeat && !std::isnan(last)) range = last;
  }
  return std::clamp(range, options_.range_min, options_.range_max);
}

double Effects::reading(int transducer, double range) {
  return last_[transducer] = disturbed(range, last_[transducer]);
}

double Effects::undisturbed(int transducer, double range) {
  disturbed(range, last_[transducer]);
  return last_[transducer] = range;
}

void Effects::add_to(Hash& hash) const {
  flicker_.add_to(hash);
  noise_.add_to(hash);
  outliers_.add_to(hash);
  for (const double shift : shift_) hash.add(shift);
  for (const double last : last_) hash.add(last);
}

}  // namespace meander::sonar
