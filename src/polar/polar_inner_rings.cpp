// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_blocks.hpp"
#include "polar/polar_lines.hpp"

namespace meander::polar {
namespace {

/// The sixteen innermost rings but the centre, as lanes: rings 1 .. 8 and 9 .. 16.
struct Inner {
  Block low, high;
};
[[gnu::always_inline]] inline void load(Inner& out, const double* from) {
  load(out.low, from), load(out.high, from + 8);
}
[[gnu::always_inline]] inline void store(double* to, const Inner& in) { store(to, in.low), store(to + 8, in.high); }
[[gnu::always_inline]] inline void add_product(Inner& sum, const Inner& x, const Inner& y) {
  add_product(sum.low, x.low, y.low), add_product(sum.high, x.high, y.high);
}
[[gnu::always_inline]] inline void add(Inner& sum, const Inner& x) {
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) {
    sum.low.part[p] = sum.low.part[p] + x.low.part[p];
    sum.high.part[p] = sum.high.part[p] + x.high.part[p];
  }
}
[[gnu::always_inline]] inline void multiply(Inner& x, const Inner& y) {
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) {
    x.low.part[p] = x.low.part[p] * y.low.part[p];
    x.high.part[p] = x.high.part[p] * y.high.part[p];
  }
}
/// open / (total - lateral * before)
[[gnu::always_inline]] inline void pivot(Inner& q, const Inner& open, const Inner& total, const Inner& lateral,
                                         const Inner& before) {
#pragma GCC unroll 4
  for (int p = 0; p < kParts; ++p) {
    q.low.part[p] = open.low.part[p] / (total.low.part[p] - lateral.low.part[p] * before.low.part[p]);
    q.high.part[p] = open.high.part[p] / (total.high.part[p] - lateral.high.part[p] * before.high.part[p]);
  }
}

/// What flows into the inner rings of a sector from the rings beside them.
[[gnu::always_inline]] inline void radial_inflow(Inner& f, const LineSystem& s, int sector) {
  const double* v = s.v + static_cast<std::size_t>(sector) * s.stride;
  Inner x, w;
  load(f, v);
  load(w, s.ring_inward + 1);
  multiply(f, w);
  load(x, v + 2);
  load(w, s.ring_outward + 1);
  add_product(f, w, x);
  if (!s.inward_diagonal) return;
  const double* left = s.v + static_cast<std::size_t>(sector == 0 ? s.sectors - 1 : sector - 1) * s.stride;
  const double* right = s.v + static_cast<std::size_t>(sector == s.sectors - 1 ? 0 : sector + 1) * s.stride;
  Inner y;
  load(x, left), load(y, right), add(x, y);
  load(w, s.ring_inward_diagonal + 1);
  add_product(f, w, x);
  load(x, left + 2), load(y, right + 2), add(x, y);
  load(w, s.ring_outward_diagonal + 1);
  add_product(f, w, x);
}

}  // namespace

void factor_rings(const LineSystem& s) {
  Inner lateral, total, open, p, q, z, none;
  zero(none.low), zero(none.high);
  load(lateral, s.ring_lateral + 1);
  load(total, s.ring_total + 1);
  p = none;
  for (int k = 0; k < 16; ++k) s.ring_z[k] = 1;
  load(z, s.ring_z);
  const int m = s.sectors;
  for (int k = 1; k < m; ++k) {
    load(open, s.ring_open + 16 * k);
    pivot(q, open, total, lateral, p);
    store(s.ring_q + 16 * k, q);
    p = q;
    multiply(p, lateral);
    store(s.ring_p + 16 * k, p);
    multiply(z, p);
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
  add(p, q);
  load(open, s.ring_open);
  pivot(q, open, total, lateral, p);
  store(s.ring_q, q);
}

void solve_rings(const LineSystem& s) {
  const int m = s.sectors;
  Inner lateral, f, y, q, p;
  load(lateral, s.ring_lateral + 1);
  zero(y.low), zero(y.high);
  for (int k = 1; k < m; ++k) {
    radial_inflow(f, s, k);
    add_product(f, lateral, y);
    load(q, s.ring_q + 16 * k);
    y = f;
    multiply(y, q);
    store(s.ring_y + 16 * k, y);
  }
  zero(q.low), zero(q.high);
  for (int k = m - 1; k > 0; --k) {
    load(y, s.ring_y + 16 * k);
    load(p, s.ring_p + 16 * k);
    add_product(y, p, q);
    store(s.ring_y + 16 * k, y);
    q = y;
  }
  Inner first, value, keep, take, old, source;
  radial_inflow(first, s, 0);
  load(p, s.ring_y + 16 * (m - 1));
  add(q, p);
  add_product(first, lateral, q);
  load(q, s.ring_q);
  multiply(first, q);
  load(source, s.source + 1);
  add(first, source);
  load(keep, s.ring_keep);
  load(take, s.ring_take);
  for (int k = 0; k < m; ++k) {
    double* v = s.v + static_cast<std::size_t>(k) * s.stride + 1;
    if (k == 0) {
      value = first;
    } else {
      load(value, s.ring_y + 16 * k);
      load(p, s.ring_z + 16 * k);
      add_product(value, p, first);
    }
    multiply(value, take);
    load(old, v);
    add_product(value, keep, old);
    store(v, value);
  }
}

}  // namespace meander::polar
