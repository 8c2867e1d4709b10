// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "base/elementary.hpp"
#include "base/random.hpp"

namespace meander {
namespace {

TEST(Elementary, ExponentialIsNearTheLibrarys) {
  Stream stream(1, "test");
  for (int i = 0; i < 200000; ++i) {
    const double x = stream.uniform(-708, 709);
    EXPECT_NEAR(exponential(x) / std::exp(x), 1, 5e-16) << x;
  }
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(-1000), 0);
  EXPECT_TRUE(std::isinf(exponential(1000)));
}

TEST(Elementary, LogarithmIsNearTheLibrarys) {
  Stream stream(2, "test");
  for (int i = 0; i < 200000; ++i) {
    const double x = std::exp(stream.uniform(-700, 700)), y = stream.uniform(0.5, 2);
    EXPECT_NEAR(logarithm(x), std::log(x), 5e-16 * std::abs(std::log(x))) << x;
    EXPECT_NEAR(logarithm(y), std::log(y), 3e-16) << y;
  }
  EXPECT_EQ(logarithm(1), 0);
}

}  // namespace
}  // namespace meander
