// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>

namespace meander::polar {

/// Arrays of one solver. Lines lie one after the other, `stride` apart; ring arrays and lines have 8 empty places on
/// both sides.
struct LineSystem {
  int sectors, padded;
  std::size_t stride;
  double* v;
  const std::size_t* row;  ///< where each sector's line factors lie
  const double *source, *nothing, *factor;
  // Weights per ring.
  const double *ring_inward, *ring_outward, *ring_lateral, *ring_inward_diagonal, *ring_outward_diagonal, *ring_total;
  // Per unit: share of the neighbours, and of the ring 1, 2, 4, 8 farther out or in. No diagonal ones: null.
  double *lateral, *inward_diagonal, *outward_diagonal, *in1, *in2, *in4, *in8, *out1, *out2, *out4, *out8;
  // Of the inner rings, 16 per sector.
  double *ring_open, *ring_q, *ring_p, *ring_z, *ring_y;
  const double *ring_keep, *ring_take;
};

/// h_i, h_i h_{i+1}, ... of the line at `row` from its factors c_i: how much of the eighth ring farther out reaches
/// ring i, and the same inwards.
void factor_line(const LineSystem& s, std::size_t row);
/// Line after line, each exactly, from the target's sector outwards on both sides and back.
void sweep_lines(const LineSystem& s);
/// Factors of the inner rings, cut open at sector 0: v_k = y_k + p_k v_{k+1}, and what v_0 = 1 adds to all the others.
void factor_rings(const LineSystem& s);
/// Solves the sixteen inner rings at once, each exactly, given the rings beside it as they were.
void solve_rings(const LineSystem& s);

}  // namespace meander::polar
