// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/sonar_model.hpp"

#include <algorithm>

#include "base/names.hpp"
#include "mapping/classic_models.hpp"
#include "mapping/sonar_network.hpp"

namespace meander {
namespace {

struct Entry {
  const char* name;
  SonarModel (*make)(const SonarModelOptions&);
};

constexpr Entry kModels[] = {
    {"elfes", [](const SonarModelOptions& options) { return cone_model(options.ring); }},
    {"ros", [](const SonarModelOptions& options) { return range_layer_model(options.ring); }},
};

}  // namespace

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
