// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/elementary.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace meander {
namespace {

constexpr double kSmallest = -708, kLargest = 709;
// ln 2 as a number with 32 bits and the rest, so that k times the first is exact.
constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;

double power_of_two(int k) { return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52); }

}  // namespace

double exponential(double x) {
  if (x < kSmallest) return 0;
  if (x > kLargest) return std::numeric_limits<double>::infinity();
  // x = k ln 2 + r with |r| <= ln(2)/2, and the series of e^r in Horner's form: its next term is below 2^-53.
  const double k = std::floor(x * std::numbers::log2e + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;
  double sum = 1;
  for (int n = 14; n >= 1; --n) sum = 1 + sum * r / n;
  return sum * power_of_two(static_cast<int>(k));
}

double logarithm(double x) {
  // x = 2^k m with m in [sqrt(1/2), sqrt(2)), and ln m = 2 artanh((m - 1)/(m + 1)).
  const auto bits = std::bit_cast<std::uint64_t>(x);
  int k = static_cast<int>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL);
  if (m >= std::numbers::sqrt2) {
    m *= 0.5;
    ++k;
  }
  const double t = (m - 1) / (m + 1), t2 = t * t;
  double sum = 0;
  for (int n = 23; n >= 3; n -= 2) sum = (sum + 1.0 / n) * t2;
  return k * kLn2High + (2 * t + (2 * t * sum + k * kLn2Low));
}

}  // namespace meander
