// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/navigators.hpp"

#include "base/error.hpp"
#include "base/names.hpp"
#include "polar/dynamic_window.hpp"
#include "polar/polar_navigator.hpp"
#include "polar/potential_field.hpp"
#include "polar/tangent_bug.hpp"
#include "polar/vfh_plus.hpp"

namespace meander {
namespace {

struct Entry {
  const char* name;
  Navigator (*make)(const Platform&);
};

constexpr Entry kNavigators[] = {
    {"polar", [](const Platform& platform) { return polar_navigator(platform); }},
    {"potential_field", [](const Platform& platform) { return potential_field(platform); }},
    {"vfh_plus", [](const Platform& platform) { return vfh_plus(platform); }},
    {"dynamic_window", [](const Platform& platform) { return dynamic_window(platform); }},
    {"tangent_bug", [](const Platform& platform) { return tangent_bug(platform); }},
};

}  // namespace

Navigator navigator_by_name(const std::string& name, const Platform& platform) {
  for (const Entry& entry : kNavigators)
    if (name == entry.name) return entry.make(platform);
  const auto names = navigator_names();
  fail("unknown navigator '{}'; known: {}{}", name, listing(names), did_you_mean(name, names));
}

std::vector<std::string> navigator_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kNavigators) names.emplace_back(entry.name);
  return names;
}

}  // namespace meander
