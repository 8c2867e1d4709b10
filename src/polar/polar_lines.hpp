// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <span>

namespace meander::polar {

/// Arrays of one solver. Lines lie one after the other, `stride` apart; ring arrays and lines have 8 empty places on
/// both sides.
struct LineSystem {
  int sectors, padded;
  std::size_t stride;
  bool diagonals;  ///< there are diagonal weights
  bool uneven;     ///< sectors differ in width; then there are no diagonal weights
  bool whole;      ///< all sixteen inner rings are solved, none is the rim or beyond it
  double* v;
  const double* const* factor;  ///< of each sector's line: c_i per ring
  const double* source;
  // Weights per ring. `total` is without the lateral ones where sectors are uneven.
  const double *inward, *outward, *lateral, *inward_diagonal, *outward_diagonal, *total;
  const double *left_share, *right_share;  ///< of the lateral weight that each sector has to its sides, when uneven
  // Of the inner rings, 16 per sector.
  double *ring_open, *ring_q, *ring_p, *ring_z, *ring_y;
  const double *ring_keep, *ring_take;
};

/// The inner loops, for registers of a width.
struct LineKernels {
  const char* name;
  /// Line after line, each exactly, from the target's sector outwards on both sides and back.
  void (*sweep_lines)(const LineSystem&);
  /// Factors of the inner rings, cut open at sector 0: v_k = y_k + p_k v_{k+1}, and what v_0 = 1 adds to all the
  /// others.
  void (*factor_rings)(const LineSystem&);
  /// Solves the sixteen inner rings at once, each exactly, given the rings beside it as they were.
  void (*solve_rings)(const LineSystem&);
};

/// Those that this machine can run, the narrowest first. All give the same bits.
std::span<const LineKernels> line_kernels();

}  // namespace meander::polar
