// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <bit>
#include <cstdint>
#include <limits>

namespace meander {

/// value 2^(512 block), value in [2^-256, 2^256): a number > 0 that does not underflow. [LM99+] Activation falls by
/// exp(-1.1) a cell in the open and exp(-2.3) in a corridor: plain doubles are 0 after 680 cells, and units without
/// activation have no way to follow. Products with powers of two are exact, so a unit has the bits it would have if
/// doubles had no end.
struct Extended {
  static constexpr std::int32_t kZeroBlock = std::numeric_limits<std::int32_t>::min() / 2;

  double value = 0;
  std::int32_t block = kZeroBlock;

  bool zero() const { return value == 0; }
  /// In units of 2^(512 base); base is at least the own block, or one less.
  double in_block(std::int32_t base) const {
    if (block == base) [[likely]]
      return value;
    if (block == base - 1) return value * 0x1p-512;
    return block == base + 1 ? value * 0x1p512 : 0;
  }
};

/// x 2^(512 block) brought to its range; x >= 0.
inline Extended extended(double x, std::int32_t block) {
  if (x == 0) return {};
  while (x < 0x1p-256) x *= 0x1p512, --block;
  return {x, block};
}

/// tanh to within 1e-12 for 0 <= x <= 0.9, with the same bits on every machine. [LM99] Phi, whose slope beta is in x.
inline double squash(double x) {
  if (x < 1e-6) return x;  // the next term is x^3 / 3
  const double q = x * x;
  return x * (135135 + q * (17325 + q * (378 + q))) / (135135 + q * (62370 + q * (3150 + q * 28)));
}

/// exp(-x) for x >= 0 with the same bits everywhere: the series for x / 2^n, squared n times.
inline double falling_exponential(double x) {
  int halvings = 0;
  for (; x > 0.25 && halvings < 16; ++halvings) x /= 2;
  double term = 1, sum = 1;
  for (int n = 1; n < 20; ++n) term *= -x / n, sum += term;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}

/// ln x to within 1e-15 for normal x > 0, with the same bits on every machine.
inline double natural_log(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  // x = 2^exponent m, m in [1 / sqrt 2, sqrt 2)
  const std::uint64_t shifted = bits - 0x3fe6a09e667f3bcdu;
  const auto exponent = static_cast<std::int64_t>(shifted) >> 52;
  const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << 52));
  const double s = (m - 1) / (m + 1), q = s * s;  // ln m = 2 artanh s
  const double series =
      1 + q * (1.0 / 3 +
               q * (1.0 / 5 +
                    q * (1.0 / 7 +
                         q * (1.0 / 9 + q * (1.0 / 11 + q * (1.0 / 13 + q * (1.0 / 15 + q * (1.0 / 17 + q / 19))))))));
  return static_cast<double>(exponent) * 0.69314718055994530942 + 2 * s * series;
}

inline double natural_log(const Extended& x) {
  return natural_log(x.value) + static_cast<double>(x.block) * (512 * 0.69314718055994530942);
}

}  // namespace meander
