// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "robot/contracts.hpp"

#include <cmath>

namespace meander {

void check_body(const Navigator& navigator, double radius) {
  constexpr double kSame = 1e-9;  ///< [m]
  if (navigator.body_radius > 0 && !(std::abs(navigator.body_radius - radius) <= kSame))
    fail("navigator '{}': made for a robot of radius {} m; this one has {} m", navigator.name, navigator.body_radius,
         radius);
}

}  // namespace meander
