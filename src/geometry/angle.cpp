// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/angle.hpp"

#include <algorithm>

namespace meander {
namespace {

// pi/2 in two parts (Cody and Waite): the first has trailing zero bits, so that quadrant * kHalfPiHigh is exact.
constexpr double kHalfPiHigh = 0x1.921fb54400000p+0;
constexpr double kHalfPiLow = 0x1.0b4611a626331p-34;

/// Taylor series on [-pi/4, pi/4]; the first omitted term is below 1e-19.
double sin_series(double x) {
  const double q = x * x;
  double s = 1.0 / 355687428096000.0;  // 1/17!
  s = s * q - 1.0 / 1307674368000.0;
  s = s * q + 1.0 / 6227020800.0;
  s = s * q - 1.0 / 39916800.0;
  s = s * q + 1.0 / 362880.0;
  s = s * q - 1.0 / 5040.0;
  s = s * q + 1.0 / 120.0;
  s = s * q - 1.0 / 6.0;
  return x + x * q * s;
}

double cos_series(double x) {
  const double q = x * x;
  double c = -1.0 / 6402373705728000.0;  // -1/18!
  c = c * q + 1.0 / 20922789888000.0;
  c = c * q - 1.0 / 87178291200.0;
  c = c * q + 1.0 / 479001600.0;
  c = c * q - 1.0 / 3628800.0;
  c = c * q + 1.0 / 40320.0;
  c = c * q - 1.0 / 720.0;
  c = c * q + 1.0 / 24.0;
  return (1.0 - 0.5 * q) + q * q * c;
}

/// atan(t) for 0 <= t <= 1: a first guess within 0.005 rad, then the exact remainder from the tangent's difference
/// formula.
double atan_unit(double t) {
  const double guess = std::min(kPi / 4, t * (kPi / 4 + 0.273 * (1 - t)));
  const SinCos g{sin_series(guess), cos_series(guess)};
  const double d = (t * g.cos - g.sin) / (g.cos + t * g.sin);  // tan of the remaining angle, |d| < 0.005
  const double q = d * d;
  return guess + d * (1.0 - q * (1.0 / 3.0 - q * (1.0 / 5.0 - q * (1.0 / 7.0 - q / 9.0))));
}

}  // namespace

SinCos sin_cos(double angle) {
  const double quadrant = std::nearbyint(angle * (2.0 / kPi));
  const double r = (angle - quadrant * kHalfPiHigh) - quadrant * kHalfPiLow;
  const double s = sin_series(r);
  const double c = cos_series(r);
  switch (static_cast<long long>(quadrant) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double angle_of(double y, double x) {
  if (x == 0 && y == 0) return 0;
  const double ax = std::abs(x), ay = std::abs(y);
  double a = ay <= ax ? atan_unit(ay / ax) : kPi / 2 - atan_unit(ax / ay);
  if (x < 0) a = kPi - a;
  return y < 0 && a < kPi ? -a : a;  // -pi is not in the range
}

double wrap_angle(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;
  const double wrapped = angle - 2 * kPi * std::ceil((angle - kPi) / (2 * kPi));
  return wrapped <= -kPi ? kPi : (wrapped > kPi ? wrapped - 2 * kPi : wrapped);
}

}  // namespace meander
