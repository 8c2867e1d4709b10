// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_lines.hpp"

#include "polar/polar_blocks.hpp"

namespace meander::polar {
namespace {

/// What flows into a block of eight rings from both neighbouring sectors and the target.
template <bool Diagonal>
[[gnu::always_inline]] inline void inflow(Block& f, const LineSystem& s, std::size_t row, const double* left,
                                          const double* right, const double* source, int i) {
  Block l, r, w;
  load(f, source + i);
  load(l, left + i);
  load(r, right + i);
  load(w, s.lateral + row + i);
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) l.part[p] = l.part[p] + r.part[p];
  add_product(f, w, l);
  if constexpr (!Diagonal) return;
  load(l, left + i - 1);
  load(r, right + i - 1);
  load(w, s.inward_diagonal + row + i);
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) l.part[p] = l.part[p] + r.part[p];
  add_product(f, w, l);
  load(l, left + i + 1);
  load(r, right + i + 1);
  load(w, s.outward_diagonal + row + i);
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) l.part[p] = l.part[p] + r.part[p];
  add_product(f, w, l);
}

/// Solves one radial line exactly, given its neighbours: g_i = f_i + h_i g_{i+1} inwards, then v_i = g_i + e_i v_{i-1}
/// outwards. Each recurrence takes eight rings at a time: three doublings give g_i in terms of g_{i+8} alone.
template <bool Diagonal>
[[gnu::always_inline]] inline void solve_line(const LineSystem& s, int sector, int left_sector, int right_sector,
                                              bool with_source) {
  const std::size_t row = s.row[sector];
  const double* left = s.v + static_cast<std::size_t>(left_sector) * s.stride;
  const double* right = s.v + static_cast<std::size_t>(right_sector) * s.stride;
  const double* source = with_source ? s.source : s.nothing;
  double* v = s.v + static_cast<std::size_t>(sector) * s.stride;
  Block f1, f2, f4, g, t, w;  // the block beyond: empty
  zero(f1), zero(f2), zero(f4), zero(g);
  for (int i = s.padded - 8; i >= 0; i -= 8) {
    Block n1, n2, n4;
    inflow<Diagonal>(n1, s, row, left, right, source, i);
    n2 = n1;
    window<1>(t, n1, f1);
    load(w, s.in1 + row + i);
    add_product(n2, w, t);
    n4 = n2;
    window<2>(t, n2, f2);
    load(w, s.in2 + row + i);
    add_product(n4, w, t);
    t = n4;
    f1 = n1, f2 = n2;
    Block u;
    window<4>(u, n4, f4);
    f4 = n4;
    load(w, s.in4 + row + i);
    add_product(t, w, u);
    load(w, s.in8 + row + i);
    add_product(t, w, g);
    g = t;
    store(v + i, g);
  }
  zero(f1), zero(f2), zero(f4), zero(g);
  for (int i = 0; i < s.padded; i += 8) {
    Block n1, n2, n4, u;
    load(n1, v + i);
    n2 = n1;
    window<7>(t, f1, n1);
    load(w, s.out1 + row + i);
    add_product(n2, w, t);
    n4 = n2;
    window<6>(t, f2, n2);
    load(w, s.out2 + row + i);
    add_product(n4, w, t);
    t = n4;
    f1 = n1, f2 = n2;
    window<4>(u, f4, n4);
    f4 = n4;
    load(w, s.out4 + row + i);
    add_product(t, w, u);
    load(w, s.out8 + row + i);
    add_product(t, w, g);
    g = t;
    store(v + i, g);
  }
}

/// Line after line from the target's sector outwards on both sides at once, then back.
template <bool Diagonal>
[[gnu::always_inline]] inline void sweep(const LineSystem& s) {
  const int m = s.sectors, half = m / 2;
  const auto line = [&](int k) __attribute__((always_inline)) {
    solve_line<Diagonal>(s, k, k == 0 ? m - 1 : k - 1, k == m - 1 ? 0 : k + 1, k == 0);
  };
  line(0);
  for (int k = 1; k <= half; ++k) {
    line(k);
    if (m - k != k) line(m - k);
  }
  for (int k = half; k > 0; --k) {
    line(k);
    if (m - k != k) line(m - k);
  }
}

}  // namespace

void sweep_lines(const LineSystem& s) {
  if (s.inward_diagonal)
    sweep<true>(s);
  else
    sweep<false>(s);
}

void factor_line(const LineSystem& s, std::size_t row) {
  Block c, w, t, u, f1, f2, f4;
  zero(f1), zero(f2), zero(f4);
  const auto times = [](Block & x, const Block& y) __attribute__((always_inline)) {
#pragma GCC unroll 4
    for (int p = 0; p < kParts; ++p) x.part[p] = x.part[p] * y.part[p];
  };
  for (int i = s.padded - 8; i >= 0; i -= 8) {
    load(c, s.factor + i);
    load(w, s.ring_lateral + i);
    times(w, c);
    store(s.lateral + row + i, w);
    if (s.inward_diagonal) {
      load(w, s.ring_inward_diagonal + i);
      times(w, c);
      store(s.inward_diagonal + row + i, w);
      load(w, s.ring_outward_diagonal + i);
      times(w, c);
      store(s.outward_diagonal + row + i, w);
    }
    load(t, s.ring_outward + i);
    times(t, c);
    store(s.in1 + row + i, t);
    window<1>(u, t, f1);
    f1 = t;
    times(t, u);
    store(s.in2 + row + i, t);
    window<2>(u, t, f2);
    f2 = t;
    times(t, u);
    store(s.in4 + row + i, t);
    window<4>(u, t, f4);
    f4 = t;
    times(t, u);
    store(s.in8 + row + i, t);
  }
  zero(f1), zero(f2), zero(f4);
  for (int i = 0; i < s.padded; i += 8) {
    load(c, s.factor + i);
    load(t, s.ring_inward + i);
    times(t, c);
    store(s.out1 + row + i, t);
    window<7>(u, f1, t);
    f1 = t;
    times(t, u);
    store(s.out2 + row + i, t);
    window<6>(u, f2, t);
    f2 = t;
    times(t, u);
    store(s.out4 + row + i, t);
    window<4>(u, f4, t);
    f4 = t;
    times(t, u);
    store(s.out8 + row + i, t);
  }
}

}  // namespace meander::polar
