// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "mapping/lanes.hpp"
#include "mapping/sonar_model.hpp"

namespace meander {

/// A cell as a transducer sees it.
struct ConePlace {
  float distance = 0;  ///< [m]
  float angle = 0;     ///< off the axis, not negative [rad]
};

/// Of a cell at `range` from the robot's centre, `off` from the bearing of a transducer that sits on a ring of
/// `radius`. Series for |off| <= 1, four digits.
inline ConePlace cone_place(float range, float off, float radius) {
  const float z = off * off;
  const float cosine = 1 - z * (0.5F - z * (1.0F / 24 - z / 720));
  const float sine = off * (1 - z * (1.0F / 6 - z * (1.0F / 120 - z / 5040)));
  const float along = range * cosine - radius, across = std::abs(range * sine);
  return {std::sqrt(along * along + across * across), mapping::angle(mapping::all(across), mapping::all(along))[0]};
}

/// Calls visit(cell, place, reading [m]) for every cell, up to `reach` from the centre, with the readings in whose
/// cones it may lie: of the transducer that points most nearly its way, and of as many beside it as have cones of
/// `half_cone` there; the ring has at least one.
template <class Visit>
void for_each_cone(const SonarSweep& sweep, const RingLayout& ring, double half_cone, const CellPlaces& cells,
                   float reach, Visit visit) {
  const auto pitch = static_cast<float>(2 * kPi / ring.count), first = static_cast<float>(ring.first);
  const auto radius = static_cast<float>(ring.radius);
  // From the centre a cell is never farther off the axis than from the transducer. No sonar is asked twice.
  const int overlapping = static_cast<int>(half_cone * ring.count / (2 * kPi) + 0.5);
  const int beside = std::min(overlapping, (ring.count - 1) / 2);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (!(cells.range[cell] <= reach)) continue;
    const float turns = (cells.bearing[cell] - first) / pitch;
    const auto nearest = static_cast<int>(std::lrint(turns));
    for (int i = nearest - beside; i <= nearest + beside; ++i) {
      const float off = (turns - static_cast<float>(i)) * pitch;
      if (!(std::abs(off) <= 1)) continue;  // also what is no number
      const int sonar = ((i % ring.count) + ring.count) % ring.count;
      visit(cell, cone_place(cells.range[cell], off, radius), sweep.ranges[static_cast<std::size_t>(sonar)]);
    }
  }
}

}  // namespace meander
