// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/error.hpp"
#include "base/names.hpp"
#include "sensor/sonar.hpp"

namespace meander {
namespace {

/// The simulator of the papers: walls answer up to 60 degrees, every reading is right.
SonarOptions ideal() {
  SonarOptions o;
  o.incidence_limit = radians(60);
  o.noise = 0;
  o.noise_proportional = 0;
  o.firing = Firing::simultaneous;
  return o;
}

/// Fitted to recorded sonar (docs/sonar.md, "The preset real"). The range stays the platform's.
SonarOptions real() {
  SonarOptions o;
  o.half_cone = radians(17.8);
  o.incidence_limit = radians(18.8);
  o.incidence_jitter = radians(11.7);
  o.jitter_hold = 12;
  o.near_field = 0;
  o.corner_range = 1.9;
  o.bounce = true;
  o.noise = 0.0005;
  o.noise_proportional = 0.0015;
  o.dropout = 0.010;
  o.spurious = 0.030;
  o.repeat = 0.058;
  return o;
}

}  // namespace

SonarOptions sonar_preset(const std::string& name) {
  if (name == "ideal") return ideal();
  if (name == "nomad") return SonarOptions{};
  if (name == "real") return real();
  fail("unknown sonar preset '{}'{} (known: {})", name, did_you_mean(name, sonar_preset_names()),
       listing(sonar_preset_names()));
}

std::vector<std::string> sonar_preset_names() { return {"ideal", "nomad", "real"}; }

}  // namespace meander
