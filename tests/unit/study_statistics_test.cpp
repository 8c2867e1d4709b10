// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"

namespace meander {
namespace {

/// The score interval holds exactly the shares p for which the observed share lies within z standard deviations of p.
TEST(Wilson, EndsSolveTheScoreEquation) {
  constexpr double z = 1.959963984540054;
  for (int n = 1; n <= 60; ++n)
    for (int k = 0; k <= n; ++k) {
      const Estimate e = wilson(k, n);
      EXPECT_DOUBLE_EQ(e.value, static_cast<double>(k) / n);
      EXPECT_LE(e.low, e.value);
      EXPECT_GE(e.high, e.value);
      for (const double p : {e.low, e.high})
        if (p > 0 && p < 1) {
          EXPECT_NEAR(std::abs(e.value - p), z * std::sqrt(p * (1 - p) / n), 1e-12);
        }
    }
}

TEST(Wilson, KnownValuesAndMirror) {
  // Newcombe (1998), table I: 81 of 263 gives 0.2553 to 0.3662, 0 of 20 gives 0 to 0.1611.
  EXPECT_NEAR(wilson(81, 263).low, 0.2553, 5e-5);
  EXPECT_NEAR(wilson(81, 263).high, 0.3662, 5e-5);
  EXPECT_EQ(wilson(0, 20).low, 0);
  EXPECT_NEAR(wilson(0, 20).high, 0.1611, 5e-5);
  EXPECT_NEAR(wilson(3, 17).low, 1 - wilson(14, 17).high, 1e-12);
  EXPECT_EQ(wilson(20, 20).high, 1);
}

TEST(Wilson, RefusesNonsense) {
  EXPECT_THROW(wilson(1, 0), ArgumentError);
  EXPECT_THROW(wilson(-1, 5), ArgumentError);
  EXPECT_THROW(wilson(6, 5), ArgumentError);
  EXPECT_THROW(wilson(1, 5, 1), ArgumentError);
  EXPECT_THROW(wilson(1, 5, std::nan("")), ArgumentError);
}

/// Over many samples from a known law, the 95 % interval holds the true mean about 95 % of the time.
TEST(Bootstrap, CoversTheTruth) {
  Stream data(1, "data"), draws(1, "bootstrap");
  int mean_held = 0, median_held = 0;
  constexpr int kSamples = 400;
  for (int i = 0; i < kSamples; ++i) {
    std::vector<double> values(40);
    for (double& v : values) v = data.normal(3, 2);
    const Estimate m = bootstrap_mean(values, draws, 400);
    const Estimate d = bootstrap_median(values, draws, 400);
    EXPECT_DOUBLE_EQ(m.value, mean(values));
    EXPECT_DOUBLE_EQ(d.value, median(values));
    mean_held += m.low <= 3 && 3 <= m.high;
    median_held += d.low <= 3 && 3 <= d.high;
  }
  EXPECT_GE(mean_held, 0.90 * kSamples);
  EXPECT_LE(mean_held, 0.985 * kSamples);
  EXPECT_GE(median_held, 0.88 * kSamples);
}

TEST(Bootstrap, SameStreamSameInterval) {
  const std::vector<double> values{1, 2, 4, 8, 16};
  Stream a(7, "x"), b(7, "x"), c(8, "x");
  const Estimate ea = bootstrap_mean(values, a), eb = bootstrap_mean(values, b), ec = bootstrap_mean(values, c);
  EXPECT_EQ(ea.low, eb.low);
  EXPECT_EQ(ea.high, eb.high);
  EXPECT_NE(ea.low + 1000 * ea.high, ec.low + 1000 * ec.high);
}

TEST(Bootstrap, OneValueIsCertain) {
  Stream stream(1, "x");
  const std::vector<double> one{5};
  EXPECT_EQ(bootstrap_mean(one, stream).low, 5);
  EXPECT_EQ(bootstrap_median(one, stream).high, 5);
  EXPECT_THROW(bootstrap_mean({}, stream), ArgumentError);
  EXPECT_THROW(bootstrap_mean(one, stream, 0), ArgumentError);
}

TEST(Bootstrap, StopsWhenAskedTo) {
  StopToken stop;
  const Work work{.stop = &stop, .progress = {}};
  const std::vector<double> two{5, 6};
  Stream stream(1, "x"), same(1, "x");
  EXPECT_EQ(bootstrap_mean(two, stream, 50, 0.9, work).low, bootstrap_mean(two, same, 50, 0.9).low);
  stop.request();
  EXPECT_THROW(bootstrap_mean(two, stream, 10, 0.95, work), Cancelled);
  EXPECT_THROW(bootstrap_median(two, stream, 10, 0.95, work), Cancelled);
  EXPECT_THROW(compare_paired(two, two, stream, 10, 0.95, work), Cancelled);
}

TEST(Paired, SeesAConstantDifferenceThroughLargeCommonNoise) {
  Stream data(2, "data"), draws(2, "bootstrap");
  std::vector<double> a, b;
  for (int i = 0; i < 50; ++i) {
    const double common = data.normal(0, 100);
    a.push_back(common + 1 + data.normal(0, 0.1));
    b.push_back(common);
  }
  const PairedComparison c = compare_paired(a, b, draws);
  EXPECT_GT(c.difference.low, 0.9);
  EXPECT_LT(c.difference.high, 1.1);
  EXPECT_EQ(c.a_larger, 50);
  EXPECT_EQ(compare_paired(a, a, draws).equal, 50);
  b.pop_back();
  EXPECT_THROW(compare_paired(a, b, draws), ArgumentError);
}

TEST(Median, OfEvenAndOddCounts) {
  EXPECT_EQ(median(std::vector<double>{3, 1, 2}), 2);
  EXPECT_EQ(median(std::vector<double>{4, 1, 2, 3}), 2.5);
}

}  // namespace
}  // namespace meander
