// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "polar/polar_blocks.hpp"
#include "polar/polar_lines.hpp"

namespace meander::polar {

/// One radial line: its activation, its neighbours' and its factors.
struct Line {
  double* v;
  const double *left, *right, *factor;
  double left_share, right_share;
};
/// What there is beside the weights that are alike on both sides.
enum class Couplings { plain, diagonal, uneven };

[[gnu::always_inline]] inline Line line_of(const LineSystem& s, int sector) {
  const auto at = [&](int k) { return s.v + static_cast<std::size_t>(k) * s.stride; };
  return {at(sector),
          at(sector == 0 ? s.sectors - 1 : sector - 1),
          at(sector == s.sectors - 1 ? 0 : sector + 1),
          s.factor[sector],
          s.left_share[sector],
          s.right_share[sector]};
}

/// What flows into a block of eight rings from both neighbouring sectors, without that along the diagonals.
template <Couplings Kind, int Lanes>
[[gnu::always_inline]] inline void inflow(Block<Lanes>& f, const LineSystem& s, const Line& line,
                                          const Block<Lanes>& factor, int i) {
  Block<Lanes> l, r, w;
  load(l, line.left + i);
  load(r, line.right + i);
  load(w, s.lateral + i);
  multiply(w, factor);
  if constexpr (Kind == Couplings::uneven) {
    scale(l, line.left_share);
    scale(r, line.right_share);
  }
  add(l, r);
  if constexpr (Kind != Couplings::diagonal) {
    f = l;
    multiply(f, w);
    return;
  }
  zero(f);
  add_product(f, w, l);
  load(l, line.left + i - 1);
  load(r, line.right + i - 1);
  load(w, s.inward_diagonal + i);
  multiply(w, factor);
  add(l, r);
  add_product(f, w, l);
  load(l, line.left + i + 1);
  load(r, line.right + i + 1);
  load(w, s.outward_diagonal + i);
  multiply(w, factor);
  add(l, r);
  add_product(f, w, l);
}

/// One of the two recurrences along a line, eight rings at a time: three doublings give x_i in terms of the ring eight
/// before alone. Keeps what the next block needs of this one.
template <int Lanes>
struct Recurrence {
  Block<Lanes> x, f1, f2, f4, h1, h2, h4;
  [[gnu::always_inline]] void begin() {
    for (Block<Lanes>* block : {&x, &f1, &f2, &f4, &h1, &h2, &h4}) zero(*block);
  }
};

/// x_i = f_i + h_i x_{i+1}, from f and h of a block: the block farther out was the last one.
template <int Lanes>
[[gnu::always_inline]] inline void inwards(Recurrence<Lanes>& k, const Block<Lanes>& f, const Block<Lanes>& h) {
  Block<Lanes> t, n2 = f, n4, n8, g2, g4, g8;
  window<1>(t, f, k.f1);
  add_product(n2, h, t);
  window<1>(t, h, k.h1);
  g2 = h, multiply(g2, t);
  n4 = n2;
  window<2>(t, n2, k.f2);
  add_product(n4, g2, t);
  window<2>(t, g2, k.h2);
  g4 = g2, multiply(g4, t);
  n8 = n4;
  window<4>(t, n4, k.f4);
  add_product(n8, g4, t);
  window<4>(t, g4, k.h4);
  g8 = g4, multiply(g8, t);
  add_product(n8, g8, k.x);
  k = {n8, f, n2, n4, h, g2, g4};
}

/// x_i = f_i + h_i x_{i-1}: the block farther in was the last one.
template <int Lanes>
[[gnu::always_inline]] inline void outwards(Recurrence<Lanes>& k, const Block<Lanes>& f, const Block<Lanes>& h) {
  Block<Lanes> t, n2 = f, n4, n8, g2, g4, g8;
  window<7>(t, k.f1, f);
  add_product(n2, h, t);
  window<7>(t, k.h1, h);
  g2 = h, multiply(g2, t);
  n4 = n2;
  window<6>(t, k.f2, n2);
  add_product(n4, g2, t);
  window<6>(t, k.h2, g2);
  g4 = g2, multiply(g4, t);
  n8 = n4;
  window<4>(t, k.f4, n4);
  add_product(n8, g4, t);
  window<4>(t, k.h4, g4);
  g8 = g4, multiply(g8, t);
  add_product(n8, g8, k.x);
  k = {n8, f, n2, n4, h, g2, g4};
}

/// Solves radial lines exactly, given their neighbours: g_i = f_i + h_i g_{i+1} inwards, then v_i = g_i + e_i v_{i-1}
/// outwards. Two lines that are not neighbours at once: while one waits for its recurrence the other goes on.
template <Couplings Kind, bool Source, int Lanes, int Count>
[[gnu::always_inline]] inline void solve_lines(const LineSystem& s, const Line (&lines)[Count]) {
  Recurrence<Lanes> state[Count];
  Block<Lanes> f, h, c;
  for (Recurrence<Lanes>& k : state) k.begin();
  for (int i = s.padded - 8; i >= 0; i -= 8) {
#pragma GCC unroll 2
    for (int k = 0; k < Count; ++k) {
      load(c, lines[k].factor + i);
      inflow<Kind>(f, s, lines[k], c, i);
      if constexpr (Source) {
        load(h, s.source + i);
        add(f, h);
      }
      load(h, s.outward + i);
      multiply(h, c);
      inwards(state[k], f, h);
      store(lines[k].v + i, state[k].x);
    }
  }
  for (Recurrence<Lanes>& k : state) k.begin();
  for (int i = 0; i < s.padded; i += 8) {
#pragma GCC unroll 2
    for (int k = 0; k < Count; ++k) {
      load(f, lines[k].v + i);
      load(c, lines[k].factor + i);
      load(h, s.inward + i);
      multiply(h, c);
      outwards(state[k], f, h);
      store(lines[k].v + i, state[k].x);
    }
  }
}

template <Couplings Kind, int Lanes>
[[gnu::always_inline]] inline void solve_both_sides(const LineSystem& s, int k) {
  const int other = s.sectors - k;
  if (other - k > 1) return solve_lines<Kind, false, Lanes>(s, {line_of(s, k), line_of(s, other)});
  solve_lines<Kind, false, Lanes>(s, {line_of(s, k)});
  if (other != k) solve_lines<Kind, false, Lanes>(s, {line_of(s, other)});
}

/// Line after line from the target's sector outwards on both sides, then back.
template <Couplings Kind, int Lanes>
[[gnu::always_inline]] inline void sweep(const LineSystem& s) {
  const int half = s.sectors / 2;
  solve_lines<Kind, true, Lanes>(s, {line_of(s, 0)});
  for (int k = 1; k <= half; ++k) solve_both_sides<Kind, Lanes>(s, k);
  for (int k = half; k > 0; --k) solve_both_sides<Kind, Lanes>(s, k);
}

template <int Lanes>
[[gnu::always_inline]] inline void sweep_lines(const LineSystem& s) {
  if (s.diagonals)
    sweep<Couplings::diagonal, Lanes>(s);
  else if (s.uneven)
    sweep<Couplings::uneven, Lanes>(s);
  else
    sweep<Couplings::plain, Lanes>(s);
}

}  // namespace meander::polar
