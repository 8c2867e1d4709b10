// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstring>
#include <utility>

namespace meander::polar {

inline constexpr int kLanes = 2;  ///< to a register of the plainest machine; four or eight gain a tenth
inline constexpr int kParts = 8 / kLanes;
using Lane = double __attribute__((vector_size(8 * kLanes)));

/// Eight numbers.
struct Block {
  Lane part[kParts];
};

// Part by part: a block copied at once goes through memory in pieces of another size than it is read in.
[[gnu::always_inline]] inline void load(Block& out, const double* from) {
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) std::memcpy(&out.part[p], from + p * kLanes, sizeof(Lane));
}
[[gnu::always_inline]] inline void store(double* to, const Block& in) {
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) std::memcpy(to + p * kLanes, &in.part[p], sizeof(Lane));
}
[[gnu::always_inline]] inline void zero(Block& out) {
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) out.part[p] = Lane{};
}

template <int Shift, int... I>
[[gnu::always_inline]] inline void join(Lane& out, const Lane& a, const Lane& b, std::integer_sequence<int, I...>) {
  out = __builtin_shufflevector(a, b, (Shift + I)...);
}

/// Elements Shift .. Shift + 7 of the sixteen numbers of a and then b.
template <int Shift>
[[gnu::always_inline]] inline void window(Block& out, const Block& a, const Block& b) {
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) {
    const int from = p + Shift / kLanes;
    const Lane& low = from < kParts ? a.part[from] : b.part[from - kParts];
    if constexpr (Shift % kLanes == 0) {
      out.part[p] = low;
    } else {
      const Lane& high = from + 1 < kParts ? a.part[from + 1] : b.part[from + 1 - kParts];
      join<Shift % kLanes>(out.part[p], low, high, std::make_integer_sequence<int, kLanes>{});
    }
  }
}

/// sum += x * y
[[gnu::always_inline]] inline void add_product(Block& sum, const Block& x, const Block& y) {
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) sum.part[p] = sum.part[p] + x.part[p] * y.part[p];
}

}  // namespace meander::polar
