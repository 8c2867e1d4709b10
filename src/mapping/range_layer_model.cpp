// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>

#include "mapping/classic_models.hpp"
#include "mapping/cone_places.hpp"
#include "mapping/log_odds.hpp"

namespace meander {
namespace {

/// P(c|o) of a reading: with t the tolerance, free up to r (1 - 2t), rising parabolas up to r (1 - t) and r (1 + t),
/// and nothing known beyond; all faded by weight = (1 - (angle / half_cone)^2) / (1 + exp(4 (distance - reliable))).
double probability(double distance, double range, double tolerance, double weight) {
  const double depth = tolerance * range;
  if (distance < range - 2 * depth) return 0.5 * (1 - weight);
  if (distance < range - depth) {
    const double rise = (distance - (range - 2 * depth)) / depth;
    return 0.5 * (1 - weight) + 0.5 * weight * rise * rise;
  }
  if (distance >= range + depth) return 0.5;
  const double off = (range - distance) / depth;
  return 0.5 + 0.5 * weight * (1 - off * off);
}

float told(const ConePlace& at, double range, const RangeLayerOptions& o, bool echo) {
  if (at.angle >= o.half_cone || (!echo && !o.clear_beyond)) return 0;
  const double distance = at.distance, off = at.angle / o.half_cone;
  const double weight = (1 - off * off) / (1 + exponential(4 * (distance - o.reliable)));
  const double p = probability(distance, range, o.tolerance, weight);
  return p == 0.5 ? 0 : log_odds_of(std::clamp(p, 0.001, 0.999));
}

}  // namespace

SonarModel range_layer_model(const RingLayout& ring, const RangeLayerOptions& options) {
  check_sonars("model \"ros\"", ring);
  validate(options);
  const double reach = options.reliable + ring.radius + 2;  // weights beyond are below 1/3000
  const auto evaluate = [=](const SonarSweep& sweep, const CellPlaces& cells, std::span<float> log_odds) {
    std::fill_n(log_odds.begin(), cells.size(), 0.0F);
    for_each_cone(sweep, ring, options.half_cone, cells, static_cast<float>(reach),
                  [&](std::size_t cell, const ConePlace& at, double range) {
                    log_odds[cell] += told(at, range, options, range < sweep.range_max);
                  });
  };
  return {.name = "ros", .ring = ring, .reach = reach, .evaluate = evaluate};
}

}  // namespace meander
