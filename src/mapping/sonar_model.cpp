// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/sonar_model.hpp"

#include <algorithm>
#include <cmath>

#include "base/names.hpp"
#include "geometry/angle.hpp"
#include "mapping/classic_models.hpp"
#include "mapping/sonar_network.hpp"

namespace meander {
namespace {

struct Entry {
  const char* name;
  SonarModel (*make)(const SonarModelOptions&);
};

constexpr Entry kModels[] = {
    {"elfes", [](const SonarModelOptions& options) { return cone_model(options.ring, options.elfes); }},
    {"ros", [](const SonarModelOptions& options) { return range_layer_model(options.ring, options.ros); }},
};

constexpr double kSamePlace = 1e-9;  ///< [m], [rad]

}  // namespace

void check_sonars(const std::string& what, const RingLayout& ring, int least) {
  validate(ring, "ring.");
  if (ring.count < least)
    fail("{}: a ring of {} sonar{} or more expected, got {}", what, least, least > 1 ? "s" : "", ring.count);
}

void check_ring(const std::string& what, const RingLayout& made_for, const RingLayout& ring) {
  const auto text = [](const RingLayout& r) {
    return fmt::format("{} sonars at {} m, the first at {} rad", r.count, r.radius, r.first);
  };
  if (made_for.count != ring.count || !(std::abs(made_for.radius - ring.radius) <= kSamePlace) ||
      !(std::abs(angle_between(made_for.first, ring.first)) <= kSamePlace))
    fail("{}: made for a ring of {}; this one has {}", what, text(made_for), text(ring));
}

SonarModel sonar_model(const std::string& name, const SonarModelOptions& options) {
  const auto networks = sonar_network_names();
  if (std::find(networks.begin(), networks.end(), name) != networks.end()) {
    const SonarNetwork network = shipped_network(name, options.preset, options.ring);
    return options.table ? table_model(network) : network_model(network);
  }
  for (const Entry& entry : kModels)
    if (name == entry.name) return entry.make(options);
  const auto names = sonar_model_names();
  fail("unknown sonar model '{}'; known: {}{}", name, listing(names), did_you_mean(name, names));
}

std::vector<std::string> sonar_model_names() {
  std::vector<std::string> names = sonar_network_names();
  for (const Entry& entry : kModels) names.emplace_back(entry.name);
  return names;
}

}  // namespace meander
