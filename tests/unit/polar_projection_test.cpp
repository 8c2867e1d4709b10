// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/projection.hpp"

#include <gtest/gtest.h>

#include "polar_support.hpp"

namespace meander {
namespace {

/// Every unit of every layer, held against the circles themselves.
TEST(Projection, ObstructsTheUnitsThatThePlainWayObstructs) {
  const std::vector<double> radii{0.3167, 0.3367, 0.5667};
  for (const PolarLayoutOptions& options :
       {PolarLayoutOptions{}, PolarLayoutOptions{.rings = 32, .sectors = 32, .radii = PolarRadii::log},
        PolarLayoutOptions{.rings = 300, .sectors = 64}, PolarLayoutOptions{.rings = 10, .sectors = 32}}) {
    const PolarLayout layout(options);
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      auto points = random_points(seed);
      points.push_back({0.05, 0.02});  // nearer than any radius
      const Projection map = projected(layout, points, radii);
      for (std::size_t layer = 0; layer < radii.size(); ++layer)
        for (int s = 0; s < layout.sectors(); ++s)
          for (int r = 0; r < layout.rings(); ++r) {
            bool inside = false, doubtful = false;
            for (const Vec2& p : points) {
              const double radius = std::min(radii[layer], p.norm() - Projection::kCentreFree);
              const double gap = (layout.position(r, s) - p).norm() - radius;
              inside = inside || gap <= 0;
              doubtful = doubtful || std::abs(gap) < 1e-12;
            }
            if (r == 0 || r == layout.rings() - 1) inside = false;
            if (doubtful) continue;
            ASSERT_EQ(map.layer(layer).test(r, s), inside) << seed << " ring " << r << " sector " << s;
          }
    }
  }
}

TEST(Projection, LeavesTheCentreFreeWhateverIsNear) {
  const PolarLayout layout({});
  for (const double distance : {0.0, 1e-4, 0.01, 0.1, 0.27}) {
    const Projection map = projected(layout, {Vec2(distance, 0)});
    for (int s = 0; s < layout.sectors(); ++s) EXPECT_FALSE(map.layer(0).test(0, s));
  }
}

TEST(PolarLayout, FindsRingsAndSectors) {
  for (const PolarRadii radii : {PolarRadii::uniform, PolarRadii::log}) {
    const PolarLayout layout({.rings = 50, .sectors = 40, .radii = radii});
    EXPECT_EQ(layout.radius(0), 0);
    EXPECT_EQ(layout.scope(), 2.54);
    for (int r = 1; r < 50; ++r) {
      EXPECT_GT(layout.radius(r), layout.radius(r - 1));
      EXPECT_EQ(layout.first_ring_from(layout.radius(r)), r);
      EXPECT_EQ(layout.first_ring_from(layout.radius(r) - 1e-9), r);
      EXPECT_EQ(layout.nearest_ring(layout.radius(r) + 1e-9), r);
    }
    EXPECT_EQ(layout.first_ring_from(3), 50);
    for (int s = 0; s < 40; ++s) EXPECT_EQ(layout.nearest_sector(layout.bearing(s)), s);
    EXPECT_EQ(layout.apart(1, 39), 2);
  }
}

}  // namespace
}  // namespace meander
