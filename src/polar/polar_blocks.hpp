// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstring>
#include <utility>

namespace meander::polar {

template <int Lanes>
struct Register;
template <>
struct Register<2> {
  using Type = double __attribute__((vector_size(16)));
};
template <>
struct Register<4> {
  using Type = double __attribute__((vector_size(32)));
};
template <>
struct Register<8> {
  using Type = double __attribute__((vector_size(64)));
};

/// Eight numbers, in registers of `Lanes`. What is done to one of them does not depend on how many share a register:
/// the same bits whichever machine it runs on.
template <int Lanes>
struct Block {
  using Lane = typename Register<Lanes>::Type;
  static constexpr int kParts = 8 / Lanes;
  Lane part[kParts];
};

// Part by part: a block copied at once goes through memory in pieces of another size than it is read in.
template <int Lanes>
[[gnu::always_inline]] inline void load(Block<Lanes>& out, const double* from) {
#pragma GCC unroll 4
  for (int p = 0; p < Block<Lanes>::kParts; ++p) std::memcpy(&out.part[p], from + p * Lanes, 8 * Lanes);
}
template <int Lanes>
[[gnu::always_inline]] inline void store(double* to, const Block<Lanes>& in) {
#pragma GCC unroll 4
  for (int p = 0; p < Block<Lanes>::kParts; ++p) std::memcpy(to + p * Lanes, &in.part[p], 8 * Lanes);
}
template <int Lanes>
[[gnu::always_inline]] inline void zero(Block<Lanes>& out) {
#pragma GCC unroll 4
  for (int p = 0; p < Block<Lanes>::kParts; ++p) out.part[p] = typename Block<Lanes>::Lane{};
}

/// Elements Shift .. Shift + Lanes - 1 of a and then b.
template <int Shift, int Lanes, int... I>
[[gnu::always_inline]] inline void join(typename Block<Lanes>::Lane& out, const typename Block<Lanes>::Lane& a,
                                        const typename Block<Lanes>::Lane& b, std::integer_sequence<int, I...>) {
  out = __builtin_shufflevector(a, b, (Shift + I)...);
}

/// Elements Shift .. Shift + 7 of the sixteen numbers of a and then b.
template <int Shift, int Lanes>
[[gnu::always_inline]] inline void window(Block<Lanes>& out, const Block<Lanes>& a, const Block<Lanes>& b) {
  constexpr int kParts = Block<Lanes>::kParts;
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) {
    const int from = p + Shift / Lanes;
    const auto& low = from < kParts ? a.part[from] : b.part[from - kParts];
    if constexpr (Shift % Lanes == 0) {
      out.part[p] = low;
    } else {
      const auto& high = from + 1 < kParts ? a.part[from + 1] : b.part[from + 1 - kParts];
      join<Shift % Lanes, Lanes>(out.part[p], low, high, std::make_integer_sequence<int, Lanes>{});
    }
  }
}

/// x *= a
template <int Lanes>
[[gnu::always_inline]] inline void scale(Block<Lanes>& x, double a) {
#pragma GCC unroll 4
  for (int p = 0; p < Block<Lanes>::kParts; ++p) x.part[p] = x.part[p] * a;
}
/// sum += x
template <int Lanes>
[[gnu::always_inline]] inline void add(Block<Lanes>& sum, const Block<Lanes>& x) {
#pragma GCC unroll 4
  for (int p = 0; p < Block<Lanes>::kParts; ++p) sum.part[p] = sum.part[p] + x.part[p];
}
/// x *= y
template <int Lanes>
[[gnu::always_inline]] inline void multiply(Block<Lanes>& x, const Block<Lanes>& y) {
#pragma GCC unroll 4
  for (int p = 0; p < Block<Lanes>::kParts; ++p) x.part[p] = x.part[p] * y.part[p];
}
/// sum += x * y
template <int Lanes>
[[gnu::always_inline]] inline void add_product(Block<Lanes>& sum, const Block<Lanes>& x, const Block<Lanes>& y) {
#pragma GCC unroll 4
  for (int p = 0; p < Block<Lanes>::kParts; ++p) sum.part[p] = sum.part[p] + x.part[p] * y.part[p];
}

}  // namespace meander::polar
