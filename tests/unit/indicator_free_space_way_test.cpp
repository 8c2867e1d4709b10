// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/free_space_way.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "indicator/geodesic_field.hpp"

namespace meander {
namespace {

TEST(FreeSpaceWay, IsAsShortAsASearchFromScratchWhileTheMapIsMade) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Stream random(seed, "way");
    ConfigurationSpace space(90, 70, {.resolution = 0.05, .origin = {}}, 0.11);
    const Cell goal{80, 60};
    FreeSpaceWay way;
    GeodesicField field;
    for (int step = 0; step < 40; ++step) {
      for (int i = 0; i < 25; ++i) {
        const Cell cell{random.below(90), random.below(70)};
        const double draw = random.uniform(0, 1);
        space.set(cell, draw < 0.3 ? Known::wall : draw < 0.8 ? Known::free : Known::nothing);
      }
      const Cell start{random.below(90), random.below(70)};
      const std::vector<Cell>& cells = way.plan(space, start, goal);
      field.spread(space, goal, 1e6, true);
      ASSERT_EQ(cells.empty(), !std::isfinite(field.at(start))) << "seed " << seed << ", step " << step;
      if (!cells.empty()) {
        ASSERT_NEAR(way.length(), field.at(start), 1e-9) << "seed " << seed << ", step " << step;
      }
    }
  }
}

}  // namespace
}  // namespace meander
