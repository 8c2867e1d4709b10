// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>

#include "mapping/classic_models.hpp"
#include "mapping/cone_places.hpp"
#include "mapping/log_odds.hpp"

namespace meander {
namespace {

float square(float x) { return x * x; }

/// [ME85] section 3: E = (1 - (distance / (r - depth))^2) (1 - (angle / half_cone)^2) of being empty before the shell,
/// O = (1 - ((distance - r) / depth)^2) (1 - (angle / half_cone)^2) of being occupied within it.
/// [ME85+] As probabilities 1/2 - free E / 2 and 1/2 + occupied O / 2, which all rules of fusion here take.
float told(const ConePlace& at, float range, const ConeModelOptions& o, bool echo) {
  const auto half_cone = static_cast<float>(o.half_cone), depth = static_cast<float>(o.depth);
  if (at.angle >= half_cone) return 0;
  const float centred = 1 - square(at.angle / half_cone);
  if (at.distance < range - depth) {
    const float empty = (1 - square(at.distance / (range - depth))) * centred;
    return log_odds_of(0.5 - 0.5 * o.free * static_cast<double>(empty));
  }
  if (!echo || at.distance > range + depth) return 0;
  return log_odds_of(0.5 +
                     0.5 * o.occupied * static_cast<double>((1 - square((at.distance - range) / depth)) * centred));
}

}  // namespace

SonarModel cone_model(const RingLayout& ring, const ConeModelOptions& options) {
  check_sonars("model \"elfes\"", ring);
  validate(options);
  const double reach = options.trust + ring.radius;
  const auto evaluate = [=](const SonarSweep& sweep, const CellPlaces& cells, std::span<float> log_odds) {
    std::fill_n(log_odds.begin(), cells.size(), 0.0F);
    for_each_cone(sweep, ring, options.half_cone, cells, static_cast<float>(reach),
                  [&](std::size_t cell, const ConePlace& at, double range) {
                    log_odds[cell] += told(at, static_cast<float>(range), options, range < sweep.range_max);
                  });
  };
  return {.name = "elfes", .ring = ring, .reach = reach, .evaluate = evaluate};
}

}  // namespace meander
