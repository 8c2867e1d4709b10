// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// No include guard: polar_solver.cpp includes this once per kind of processor, each time in a namespace of its own and
// with MEANDER_LANES numbers to a register. What is computed, and in which order, does not depend on MEANDER_LANES, so
// all give the same bits.

constexpr int kLanes = MEANDER_LANES;
constexpr int kParts = 8 / kLanes;
using Lane = double __attribute__((vector_size(8 * kLanes)));
#define MEANDER_INLINE_LAMBDA __attribute__((always_inline))
#define MEANDER_INLINE MEANDER_INLINE_LAMBDA inline

/// Eight numbers.
struct Block {
  Lane part[kParts];
};

MEANDER_INLINE void load(Block& out, const double* from) { std::memcpy(&out, from, sizeof out); }
MEANDER_INLINE void store(double* to, const Block& in) { std::memcpy(to, &in, sizeof in); }
MEANDER_INLINE void zero(Block& out) {
  for (int p = 0; p < kParts; ++p) out.part[p] = Lane{};
}

template <int Shift, int... I>
MEANDER_INLINE void join(Lane& out, const Lane& a, const Lane& b, std::integer_sequence<int, I...>) {
  out = __builtin_shufflevector(a, b, (Shift + I)...);
}

/// Elements Shift .. Shift + 7 of the sixteen numbers of a and then b.
template <int Shift>
MEANDER_INLINE void window(Block& out, const Block& a, const Block& b) {
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
MEANDER_INLINE void add_product(Block& sum, const Block& x, const Block& y) {
  for (int p = 0; p < kParts; ++p) sum.part[p] = sum.part[p] + x.part[p] * y.part[p];
}

/// What flows into a block of eight rings from both neighbouring sectors and the target.
template <bool Diagonal>
MEANDER_INLINE void inflow(Block& f, const LineSystem& s, std::size_t row, const double* left, const double* right,
                           const double* source, int i) {
  Block l, r, w;
  load(f, source + i);
  load(l, left + i);
  load(r, right + i);
  load(w, s.lateral + row + i);
  for (int p = 0; p < kParts; ++p) l.part[p] = l.part[p] + r.part[p];
  add_product(f, w, l);
  if constexpr (!Diagonal) return;
  load(l, left + i - 1);
  load(r, right + i - 1);
  load(w, s.inward_diagonal + row + i);
  for (int p = 0; p < kParts; ++p) l.part[p] = l.part[p] + r.part[p];
  add_product(f, w, l);
  load(l, left + i + 1);
  load(r, right + i + 1);
  load(w, s.outward_diagonal + row + i);
  for (int p = 0; p < kParts; ++p) l.part[p] = l.part[p] + r.part[p];
  add_product(f, w, l);
}

/// Solves one radial line exactly, given its neighbours: g_i = f_i + h_i g_{i+1} inwards, then v_i = g_i + e_i v_{i-1}
/// outwards. Each recurrence takes eight rings at a time: three doublings give g_i in terms of g_{i+8} alone.
template <bool Diagonal>
MEANDER_INLINE void solve_line(const LineSystem& s, int sector, int left_sector, int right_sector, bool with_source) {
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
MEANDER_INLINE void sweep(const LineSystem& s) {
  const int m = s.sectors, half = m / 2;
  const auto line = [&](int k) MEANDER_INLINE_LAMBDA {
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

void sweep_lines(const LineSystem& s) {
  if (s.inward_diagonal)
    sweep<true>(s);
  else
    sweep<false>(s);
}

/// h_i, h_i h_{i+1}, ... of one line from its factors c_i: how much of the eighth ring farther out reaches ring i, and
/// the same inwards.
void factor_line(const LineSystem& s, std::size_t row) {
  Block c, w, t, u, f1, f2, f4;
  zero(f1), zero(f2), zero(f4);
  const auto times = [](Block& x, const Block& y) MEANDER_INLINE_LAMBDA {
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

/// The sixteen innermost rings but the centre, as lanes: rings 1 .. 8 and 9 .. 16.
struct Inner {
  Block low, high;
};
MEANDER_INLINE void load(Inner& out, const double* from) { load(out.low, from), load(out.high, from + 8); }
MEANDER_INLINE void store(double* to, const Inner& in) { store(to, in.low), store(to + 8, in.high); }
MEANDER_INLINE void add_product(Inner& sum, const Inner& x, const Inner& y) {
  add_product(sum.low, x.low, y.low), add_product(sum.high, x.high, y.high);
}
MEANDER_INLINE void add(Inner& sum, const Inner& x) {
  for (int p = 0; p < kParts; ++p) {
    sum.low.part[p] = sum.low.part[p] + x.low.part[p];
    sum.high.part[p] = sum.high.part[p] + x.high.part[p];
  }
}
MEANDER_INLINE void multiply(Inner& x, const Inner& y) {
  for (int p = 0; p < kParts; ++p) {
    x.low.part[p] = x.low.part[p] * y.low.part[p];
    x.high.part[p] = x.high.part[p] * y.high.part[p];
  }
}
/// open / (total - lateral * before)
MEANDER_INLINE void pivot(Inner& q, const Inner& open, const Inner& total, const Inner& lateral, const Inner& before) {
  for (int p = 0; p < kParts; ++p) {
    q.low.part[p] = open.low.part[p] / (total.low.part[p] - lateral.low.part[p] * before.low.part[p]);
    q.high.part[p] = open.high.part[p] / (total.high.part[p] - lateral.high.part[p] * before.high.part[p]);
  }
}

/// What flows into the inner rings of a sector from the rings beside them.
MEANDER_INLINE void radial_inflow(Inner& f, const LineSystem& s, int sector) {
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

/// Factors of the inner rings, cut open at sector 0: v_k = y_k + p_k v_{k+1}, and what v_0 = 1 adds to all the others.
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

/// Solves all inner rings at once, each exactly, given the rings beside it as they were.
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

#undef MEANDER_INLINE
#undef MEANDER_INLINE_LAMBDA
