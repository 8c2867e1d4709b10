// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstring>

namespace meander::mapping {

/// Four numbers in one register of the plainest machine. What is computed lane by lane has the same bits in every build
/// and on every machine; sums over lanes are taken in one fixed order.
using Lanes = float __attribute__((vector_size(16)));
inline constexpr int kLanes = 4;

[[gnu::always_inline]] inline Lanes all(float x) { return Lanes{x, x, x, x}; }
[[gnu::always_inline]] inline Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
[[gnu::always_inline]] inline void store(float* to, Lanes lanes) { std::memcpy(to, &lanes, sizeof lanes); }
[[gnu::always_inline]] inline float sum(Lanes x) { return (x[0] + x[2]) + (x[1] + x[3]); }
[[gnu::always_inline]] inline Lanes least(Lanes a, Lanes b) { return a < b ? a : b; }
[[gnu::always_inline]] inline Lanes most(Lanes a, Lanes b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Lanes magnitude(Lanes x) { return most(x, -x); }

/// To within 2e-5: x P(x^2) / Q(x^2) of least error up to |x| = 6, constant beyond.
[[gnu::always_inline]] inline Lanes tanh(Lanes x) {
  x = most(least(x, all(6.0F)), all(-6.0F));
  const Lanes z = x * x;
  const Lanes p = (0.00149555705F * z + 0.114472785F) * z + 0.999971157F;
  const Lanes q = ((5.51862375e-05F * z + 0.0174874275F) * z + 0.447714159F) * z + 1.0F;
  return x * p / q;
}

/// 1 / (1 + exp(-z)), to within 1e-5.
[[gnu::always_inline]] inline Lanes logistic(Lanes z) { return 0.5F + 0.5F * tanh(0.5F * z); }

/// Angle of (x, y) in [-pi, pi], to within 3e-6; 0 for (0, 0).
[[gnu::always_inline]] inline Lanes angle(Lanes y, Lanes x) {
  const Lanes ax = magnitude(x), ay = magnitude(y);
  const Lanes t = least(ax, ay) / most(most(ax, ay), all(1e-30F));
  const Lanes z = t * t;
  Lanes a = ((((-0.0117191353F * z + 0.0526473504F) * z - 0.116426481F) * z + 0.193540376F) * z - 0.332622828F) * z +
            0.999977219F;
  a *= t;
  a = ay > ax ? 1.57079633F - a : a;
  a = x < 0.0F ? 3.14159265F - a : a;
  return y < 0.0F ? -a : a;
}

}  // namespace meander::mapping
