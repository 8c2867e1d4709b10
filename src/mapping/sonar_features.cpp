// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/sonar_features.hpp"

#include <algorithm>

#include "base/names.hpp"
#include "geometry/angle.hpp"

namespace meander {
namespace {

struct Entry {
  const char* name;
  SonarFeatures features;
};

constexpr Entry kNetworks[] = {
    {"nn1", {.sonars = 2}},
    {"nn2", {.sonars = 3}},
    {"nn3", {.sonars = 2, .bearing = true}},
    // [CN+] Where the third sonar and the angle help, they help together.
    {"nn4", {.sonars = 3, .bearing = true}},
    {"nn5", {.sonars = 3, .bearing = true, .residual = true}},
};

}  // namespace

void check_features(const SonarFeatures& f) {
  if (f.sonars != 2 && f.sonars != 3) fail("features: 2 or 3 sonars expected, got {}", f.sonars);
  const auto check = [](const char* what, double value) {
    if (!(value >= 0.01 && value <= 100)) fail("features: {} from 0.01 to 100 m expected, got {}", what, value);
  };
  check("range cap", f.range_cap);
  check("reach", f.reach);
  check("residual scale", f.residual_scale);
}

SonarFeatures sonar_features(const std::string& network) {
  for (const Entry& entry : kNetworks)
    if (network == entry.name) return entry.features;
  const auto names = sonar_network_names();
  fail("unknown network '{}'; known: {}{}", network, listing(names), did_you_mean(network, names));
}

std::vector<std::string> sonar_network_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kNetworks) names.emplace_back(entry.name);
  return names;
}

namespace mapping {

SonarSelector::SonarSelector(const RingLayout& ring, const SonarFeatures& features)
    : ring_(ring), features_(features), per_pitch_(static_cast<float>(ring.count / (2 * kPi))) {
  check_sonars("sonar network", ring, 3);
  check_features(features);
  readings_.assign(static_cast<std::size_t>(2 * kTurns * ring.count + 2), 0.0F);
}

void SonarSelector::take(const SonarSweep& sweep) {
  const auto count = static_cast<std::size_t>(ring_.count);
  if (sweep.ranges.size() != count) fail("sonar network: {} ranges expected, got {}", count, sweep.ranges.size());
  reach_ = static_cast<float>(std::min(features_.reach, sweep.range_max + ring_.radius));
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    const double range = sweep.ranges[(i + count - 1) % count];
    const bool echo = range < sweep.range_max;  // no number is none
    readings_[i] =
        static_cast<float>(echo ? std::clamp(range + ring_.radius, 0.0, features_.range_cap) : features_.range_cap);
  }
}

}  // namespace mapping
}  // namespace meander
