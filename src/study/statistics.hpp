// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>

#include "base/random.hpp"
#include "base/work.hpp"

namespace meander {

/// A value with the interval that holds the true one with the confidence asked for.
struct Estimate {
  double value = 0;
  double low = 0;
  double high = 0;
};

double mean(std::span<const double> values);
/// Mean of the two middle values when there is no middle one.
double median(std::span<const double> values);

/// Share of successes with the score interval of Wilson (1927). Throws ArgumentError unless 0 <= successes <= trials
/// and trials > 0 and the confidence is inside (0, 1).
Estimate wilson(int successes, int trials, double confidence = 0.95);

/// Mean / median with the percentile bootstrap interval (Efron 1979): the quantiles of the same statistic over
/// `resamples` samples drawn with replacement. The stream decides the draws, so the interval is repeatable.
/// Asks `work` before every sample whether to go on.
Estimate bootstrap_mean(std::span<const double> values, Stream& stream, int resamples = 2000, double confidence = 0.95,
                        const Work& work = {});
Estimate bootstrap_median(std::span<const double> values, Stream& stream, int resamples = 2000,
                          double confidence = 0.95, const Work& work = {});

/// Two ways tried on the same seeds: a[i] and b[i] belong to trial i.
struct PairedComparison {
  Estimate difference;  ///< mean of a - b
  int a_larger = 0;
  int b_larger = 0;
  int equal = 0;
};
PairedComparison compare_paired(std::span<const double> a, std::span<const double> b, Stream& stream,
                                int resamples = 2000, double confidence = 0.95, const Work& work = {});

}  // namespace meander
