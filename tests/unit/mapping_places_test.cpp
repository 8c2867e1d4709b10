// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "mapping/cell_places.hpp"
#include "mapping/lanes.hpp"

namespace meander {
namespace {

TEST(Lanes, CurvesKeepWithinTheirBounds) {
  double tanh_error = 0, logistic_error = 0, angle_error = 0;
  for (double x = -20; x <= 20; x += 0.001) {
    tanh_error = std::max(tanh_error, std::abs(mapping::tanh(mapping::all(static_cast<float>(x)))[0] - std::tanh(x)));
    logistic_error = std::max(
        logistic_error, std::abs(mapping::logistic(mapping::all(static_cast<float>(x)))[0] - 1 / (1 + std::exp(-x))));
  }
  for (double a = -3.14159; a <= 3.14159; a += 0.001) {
    const auto y = static_cast<float>(2 * std::sin(a)), x = static_cast<float>(2 * std::cos(a));
    angle_error = std::max(angle_error, std::abs(mapping::angle(mapping::all(y), mapping::all(x))[0] - a));
  }
  EXPECT_LT(tanh_error, 2e-5);
  EXPECT_LT(logistic_error, 1e-5);
  EXPECT_LT(angle_error, 3e-6);
  EXPECT_EQ(mapping::angle(mapping::all(0), mapping::all(0))[0], 0);
}

TEST(CellPlaces, AreThoseOfPlainTrigonometry) {
  Stream random(1, "places");
  for (int trial = 0; trial < 200; ++trial) {
    const int columns = 1 + random.below(61), rows = 1 + random.below(61);
    const Vec2 first(random.uniform(-3, 1), random.uniform(-3, 1));
    const double cell = random.uniform(0.02, 0.2), heading = random.uniform(-kPi, kPi);
    const auto cells = static_cast<std::size_t>(columns * rows);
    std::vector<float> range(cells), bearing(cells);
    cell_places(first, cell, columns, rows, heading, range, bearing);
    const int column = random.below(columns), row = random.below(rows);
    const Vec2 at = first + cell * Vec2(column, row);
    const auto i = static_cast<std::size_t>(row * columns + column);
    EXPECT_NEAR(range[i], at.norm(), 3e-6);
    EXPECT_NEAR(wrap_angle(bearing[i] - (angle_of(at.y(), at.x()) - heading)), 0, 1e-5 + 1e-6 / at.norm());
    EXPECT_LE(std::abs(bearing[i]), 2 * kPi + 1e-5);
  }
}

}  // namespace
}  // namespace meander
