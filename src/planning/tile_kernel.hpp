// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>

namespace meander {

inline constexpr int kTile = 16;  ///< cells of a tile's side

/// One unit of work: the cells of a tile that hang together, and what surrounds them. Row 0 is the lowest.
struct alignas(64) TileScratch {
  enum Side { below, above, left, right };

  double cell[kTile][kTile];    ///< activation; 0 where there is none
  double turned[kTile][kTile];  ///< the same with rows and columns exchanged, while columns are swept
  double west[kTile][kTile];    ///< the neighbours to the left of each row's cells, or both neighbours' sum
  double east[kTile][kTile];
  double gain[kTile][kTile];  ///< tanh(u) / u of each cell, 0 for targets; with `curved` only
  double hold[kTile][kTile];  ///< how much of its own activation a cell keeps, 1 for targets; with `curved` only
  double turned_gain[kTile][kTile];
  double turned_hold[kTile][kTile];
  double others[kTile][kTile];    ///< cells of other units of the tile, where there are any
  double edge[4][kTile];          ///< activation of the neighbours outside, by Side
  double corner[4];               ///< lower left, lower right, upper left, upper right
  std::uint16_t open[2][kTile];   ///< bit x of row y: the cell belongs to the unit; and of the columns
  const std::uint32_t* links[2];  ///< null: every diagonal between open cells is a link; else see TileMap::Links
  bool shared;                    ///< the tile has other units
  bool full;                      ///< all 256 cells belong to the unit
  bool curved;                    ///< tanh is not the identity here
  bool sweep_rows, sweep_columns;

  double keep, straight, slant;  ///< 1 - omega, omega beta, omega beta / sqrt 2
  /// Largest relative change of a cell in the last sweep as a power of two, times 2^20, about.
  std::int32_t change;
};

/// One side of a unit after it was relaxed, and the neighbours across.
struct alignas(64) TileEdge {
  double now[kTile], old[kTile], across[kTile];
  double share[kTile];  ///< how much of its activation each neighbour across may gain or lose
  double straight, slant;
  std::uint32_t open;  ///< bit x: there is a neighbour across
  double most_share, most_now;
};

/// The same functions for several processors: they give the same bits.
struct TileKernel {
  const char* name;
  /// Over-relaxed sweeps: rows from below and from above at once, through to the other side; then columns.
  void (*relax)(TileScratch&);
  /// Largest relative error of a cell's equation; expects omega = 1.
  double (*residual)(TileScratch&);
  void (*effect)(TileEdge&);
};

/// Those that this processor can run, the fastest last; the first runs anywhere.
std::span<const TileKernel* const> tile_kernels();

}  // namespace meander
