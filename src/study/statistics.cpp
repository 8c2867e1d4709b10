// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/statistics.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/error.hpp"

namespace meander {
namespace {

void check_confidence(double confidence) {
  if (!(confidence > 0 && confidence < 1)) fail("confidence: a number inside (0, 1) expected, got {}", confidence);
}

/// Number of standard deviations on both sides of the mean of a normal distribution that hold this share of it.
double two_sided_quantile(double confidence) { return std::sqrt(2.0) * boost::math::erf_inv(confidence); }

/// The value below which this share of the sorted values lies, linear between neighbours.
double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

template <class Statistic>
Estimate bootstrap(std::span<const double> values, Stream& stream, int resamples, double confidence, const Work& work,
                   Statistic statistic) {
  if (values.empty()) fail("at least one value expected, got none");
  if (resamples < 1) fail("resamples: a number >= 1 expected, got {}", resamples);
  check_confidence(confidence);
  const int count = static_cast<int>(values.size());
  std::vector<double> sample(values.size()), found(static_cast<std::size_t>(resamples));
  for (double& result : found) {
    work.poll();
    for (double& drawn : sample) drawn = values[static_cast<std::size_t>(stream.below(count))];
    result = statistic(sample);
  }
  std::sort(found.begin(), found.end());
  const double tail = 0.5 * (1 - confidence);
  return {statistic(values), quantile(found, tail), quantile(found, 1 - tail)};
}

}  // namespace

double mean(std::span<const double> values) {
  if (values.empty()) fail("at least one value expected, got none");
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double median(std::span<const double> values) {
  if (values.empty()) fail("at least one value expected, got none");
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return quantile(sorted, 0.5);
}

Estimate wilson(int successes, int trials, double confidence) {
  if (trials < 1) fail("trials: a number >= 1 expected, got {}", trials);
  if (successes < 0 || successes > trials) fail("successes: a number from 0 to {} expected, got {}", trials, successes);
  check_confidence(confidence);
  const double z = two_sided_quantile(confidence);
  const double n = trials, p = successes / n;
  const double centre = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {p, successes == 0 ? 0 : centre - half, successes == trials ? 1 : centre + half};
}

Estimate bootstrap_mean(std::span<const double> values, Stream& stream, int resamples, double confidence,
                        const Work& work) {
  return bootstrap(values, stream, resamples, confidence, work, [](std::span<const double> v) { return mean(v); });
}

Estimate bootstrap_median(std::span<const double> values, Stream& stream, int resamples, double confidence,
                          const Work& work) {
  return bootstrap(values, stream, resamples, confidence, work, [](std::span<const double> v) { return median(v); });
}

PairedComparison compare_paired(std::span<const double> a, std::span<const double> b, Stream& stream, int resamples,
                                double confidence, const Work& work) {
  if (a.size() != b.size()) fail("as many values in both expected, got {} and {}", a.size(), b.size());
  PairedComparison result;
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) {
    differences.push_back(a[i] - b[i]);
    ++(a[i] > b[i] ? result.a_larger : a[i] < b[i] ? result.b_larger : result.equal);
  }
  result.difference = bootstrap_mean(differences, stream, resamples, confidence, work);
  return result;
}

}  // namespace meander
