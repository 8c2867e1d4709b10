// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "robot/platform.hpp"

#include <array>

namespace meander {
namespace {

// Sources of the figures: docs/simulation.md.
const std::array<Platform, 3> kPlatforms{
    Platform{.name = "nomad200",
             .body = {.radius = 0.2667,
                      .v_max = 0.6096,
                      .v_min = 0,
                      .w_max = 0.7853981633974483,
                      .a_v = 0.762,
                      .a_w = 1.0471975511965976},
             .sonar = {.count = 16, .radius = 0.23, .first = 0},
             .bumper = {.count = 20, .radius = 0.2667, .first = 0},
             .period = 0.33},
    Platform{.name = "scout",
             .body = {.radius = 0.19,
                      .v_max = 1.0,
                      .v_min = 0,
                      .w_max = 1.5707963267948966,
                      .a_v = 2.0,
                      .a_w = 3.141592653589793},
             .sonar = {.count = 16, .radius = 0.18, .first = 0},
             .bumper = {.count = 6, .radius = 0.19, .first = 0},
             .period = 0.2},
    Platform{.name = "alice",
             .body = {.radius = 0.15,
                      .v_max = 0.25,
                      .v_min = 0,
                      .w_max = 1.5707963267948966,
                      .a_v = 1.25,
                      .a_w = 6.283185307179586,
                      .drive = DriveKind::omnidirectional},
             .sonar = {.count = 0, .radius = 0.15, .first = 0},
             .bumper = {.count = 0, .radius = 0.15, .first = 0},
             .whisker = {.count = 24, .radius = 0.15, .first = 0},
             .light = {.count = 24, .radius = 0.15, .first = 0},
             .period = 0.2},
};

}  // namespace

const Platform& platform(const std::string& name) {
  for (const Platform& known : kPlatforms)
    if (known.name == name) return known;
  const auto names = platform_names();
  fail("unknown platform '{}'; known: {}{}", name, listing(names), did_you_mean(name, names));
}

std::vector<std::string> platform_names() {
  std::vector<std::string> names;
  for (const Platform& known : kPlatforms) names.push_back(known.name);
  return names;
}

}  // namespace meander
