// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "polar/polar_blocks.hpp"
#include "polar/polar_lines.hpp"

namespace meander::polar {

/// The sixteen innermost rings but the centre, as lanes: rings 1 .. 8 and 9 .. 16.
template <int Lanes>
struct Inner {
  Block<Lanes> low, high;
};
template <int Lanes>
[[gnu::always_inline]] inline void load(Inner<Lanes>& out, const double* from) {
  load(out.low, from), load(out.high, from + 8);
}
template <int Lanes>
[[gnu::always_inline]] inline void store(double* to, const Inner<Lanes>& in) {
  store(to, in.low), store(to + 8, in.high);
}
template <int Lanes>
[[gnu::always_inline]] inline void zero(Inner<Lanes>& out) {
  zero(out.low), zero(out.high);
}
template <int Lanes>
[[gnu::always_inline]] inline void add_product(Inner<Lanes>& sum, const Inner<Lanes>& x, const Inner<Lanes>& y) {
  add_product(sum.low, x.low, y.low), add_product(sum.high, x.high, y.high);
}
template <int Lanes>
[[gnu::always_inline]] inline void add(Inner<Lanes>& sum, const Inner<Lanes>& x) {
  add(sum.low, x.low), add(sum.high, x.high);
}
template <int Lanes>
[[gnu::always_inline]] inline void multiply(Inner<Lanes>& x, const Inner<Lanes>& y) {
  multiply(x.low, y.low), multiply(x.high, y.high);
}
template <int Lanes>
[[gnu::always_inline]] inline void scale(Inner<Lanes>& x, double a) {
  scale(x.low, a), scale(x.high, a);
}
/// open / (total - lateral * before)
template <int Lanes>
[[gnu::always_inline]] inline void pivot(Inner<Lanes>& q, const Inner<Lanes>& open, const Inner<Lanes>& total,
                                         const Inner<Lanes>& lateral, const Inner<Lanes>& before) {
#pragma GCC unroll 4
  for (int p = 0; p < Block<Lanes>::kParts; ++p) {
    q.low.part[p] = open.low.part[p] / (total.low.part[p] - lateral.low.part[p] * before.low.part[p]);
    q.high.part[p] = open.high.part[p] / (total.high.part[p] - lateral.high.part[p] * before.high.part[p]);
  }
}

/// What flows into the inner rings of a sector from the rings beside them.
template <int Lanes>
[[gnu::always_inline]] inline void radial_inflow(Inner<Lanes>& f, const LineSystem& s, int sector) {
  const double* v = s.v + static_cast<std::size_t>(sector) * s.stride;
  Inner<Lanes> x, w;
  load(f, v);
  load(w, s.inward + 1);
  multiply(f, w);
  load(x, v + 2);
  load(w, s.outward + 1);
  add_product(f, w, x);
  if (!s.diagonals) return;
  const double* left = s.v + static_cast<std::size_t>(sector == 0 ? s.sectors - 1 : sector - 1) * s.stride;
  const double* right = s.v + static_cast<std::size_t>(sector == s.sectors - 1 ? 0 : sector + 1) * s.stride;
  Inner<Lanes> y;
  load(x, left), load(y, right), add(x, y);
  load(w, s.inward_diagonal + 1);
  add_product(f, w, x);
  load(x, left + 2), load(y, right + 2), add(x, y);
  load(w, s.outward_diagonal + 1);
  add_product(f, w, x);
}

template <bool Uneven, int Lanes>
[[gnu::always_inline]] inline void factor_rings_of(const LineSystem& s) {
  Inner<Lanes> lateral, total, left, all, open, p, q, z;
  load(lateral, s.lateral + 1);
  load(total, s.total + 1);
  left = lateral, all = total;
  const auto at = [&](int k) __attribute__((always_inline)) {
    if constexpr (!Uneven) return;
    left = lateral, scale(left, s.left_share[k]);
    all = lateral, scale(all, s.left_share[k] + s.right_share[k]), add(all, total);
  };
  zero(p);
  for (int k = 0; k < 16; ++k) s.ring_z[k] = 1;
  load(z, s.ring_z);
  const int m = s.sectors;
  for (int k = 1; k < m; ++k) {
    load(open, s.ring_open + 16 * k);
    at(k);
    pivot(q, open, all, left, p);
    store(s.ring_q + 16 * k, q);
    p = q;
    multiply(p, left);
    multiply(z, p);
    if constexpr (Uneven) p = q, multiply(p, lateral), scale(p, s.right_share[k]);
    store(s.ring_p + 16 * k, p);
    store(s.ring_z + 16 * k, z);
  }
  load(q, s.ring_z);  // sector m is sector 0
  for (int k = m - 1; k > 0; --k) {
    load(z, s.ring_z + 16 * k);
    load(p, s.ring_p + 16 * k);
    add_product(z, p, q);
    store(s.ring_z + 16 * k, z);
    q = z;
  }
  load(p, s.ring_z + 16);
  load(q, s.ring_z + 16 * (m - 1));
  if constexpr (Uneven) scale(p, s.right_share[0]), scale(q, s.left_share[0]);
  add(p, q);
  load(open, s.ring_open);
  at(0);
  pivot(q, open, all, lateral, p);
  store(s.ring_q, q);
}
template <int Lanes>
[[gnu::always_inline]] inline void factor_rings(const LineSystem& s) {
  if (s.uneven)
    factor_rings_of<true, Lanes>(s);
  else
    factor_rings_of<false, Lanes>(s);
}

/// Rings that are not solved keep what they have.
template <int Lanes>
[[gnu::always_inline]] inline void store_solved(const LineSystem& s, double* v, Inner<Lanes>& value) {
  if (!s.whole) {
    Inner<Lanes> share, old;
    load(share, s.ring_take);
    multiply(value, share);
    load(share, s.ring_keep);
    load(old, v);
    add_product(value, share, old);
  }
  store(v, value);
}

template <bool Uneven, int Lanes>
[[gnu::always_inline]] inline void solve_rings_of(const LineSystem& s) {
  const int m = s.sectors;
  Inner<Lanes> lateral, f, y, q, p;
  load(lateral, s.lateral + 1);
  zero(y);
  for (int k = 1; k < m; ++k) {
    radial_inflow(f, s, k);
    if constexpr (Uneven) scale(y, s.left_share[k]);
    add_product(f, lateral, y);
    load(q, s.ring_q + 16 * k);
    y = f;
    multiply(y, q);
    store(s.ring_y + 16 * k, y);
  }
  zero(q);
  for (int k = m - 1; k > 0; --k) {
    load(y, s.ring_y + 16 * k);
    load(p, s.ring_p + 16 * k);
    add_product(y, p, q);
    store(s.ring_y + 16 * k, y);
    q = y;
  }
  Inner<Lanes> first, value, source;
  radial_inflow(first, s, 0);
  load(p, s.ring_y + 16 * (m - 1));
  if constexpr (Uneven) scale(q, s.right_share[0]), scale(p, s.left_share[0]);
  add(q, p);
  add_product(first, lateral, q);
  load(q, s.ring_q);
  multiply(first, q);
  load(source, s.source + 1);
  add(first, source);
  value = first;
  store_solved(s, s.v + 1, value);
  for (int k = 1; k < m; ++k) {
    load(value, s.ring_y + 16 * k);
    load(p, s.ring_z + 16 * k);
    add_product(value, p, first);
    store_solved(s, s.v + static_cast<std::size_t>(k) * s.stride + 1, value);
  }
}
template <int Lanes>
[[gnu::always_inline]] inline void solve_rings(const LineSystem& s) {
  if (s.uneven)
    solve_rings_of<true, Lanes>(s);
  else
    solve_rings_of<false, Lanes>(s);
}

}  // namespace meander::polar
