// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>

#include "base/elementary.hpp"

namespace meander {

/// ln(p / (1 - p)).
inline float log_odds_of(double p) { return static_cast<float>(logarithm(p / (1 - p))); }
/// [CN] eq. (2): 1 - 1 / (1 + b), b the odds.
inline float probability_of(float log_odds) {
  return static_cast<float>(1 - 1 / (1 + exponential(static_cast<double>(log_odds))));
}

/// Adds evidence to `count` cells, each of which stays within the limit.
void add_evidence(float* cells, const float* increments, std::size_t count, float limit);

}  // namespace meander
