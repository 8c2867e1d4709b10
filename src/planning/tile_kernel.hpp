// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <numbers>
#include <span>

namespace meander {

inline constexpr int kTile = 16;  ///< cells of a tile's side
inline constexpr double kRootHalf = std::numbers::sqrt2 / 2;

/// Activation of a tile's cells; the leftmost column and the rightmost once more, as rows of memory.
struct alignas(64) TileCells {
  double cell[kTile][kTile];  ///< row 0 is the lowest; 0 where there is none
  double side[2][kTile];
};

/// One unit of work: the cells of a tile that hang together, and what surrounds them.
struct alignas(64) TileScratch {
  enum Side { below, above, left, right };

  double own[kTile][kTile];     ///< the unit's cells alone, where the tile has other units
  double turned[kTile][kTile];  ///< the cells with rows and columns exchanged, while columns are swept
  double west[kTile][kTile];    ///< the neighbours to the left of each row's cells, or both neighbours' sum
  double east[kTile][kTile];
  double turned_gain[kTile][kTile];
  double turned_hold[kTile][kTile];
  double brought[4][kTile];       ///< edges that had to be scaled
  double old[4][kTile];           ///< the unit's cells along each side, before
  double now[4][kTile];           ///< and after
  double (*cell)[kTile];          ///< the unit's cells: `own`, or those of the tile
  TileCells* home;                ///< the tile
  const double* edge[4];          ///< activation of the neighbours outside, by Side
  double corner[4];               ///< lower left, lower right, upper left, upper right
  const double (*gain)[kTile];    ///< tanh(u) / u of each cell, 0 for targets; null: tanh is the identity here
  const double (*hold)[kTile];    ///< how much of its own activation a cell keeps, 1 for targets
  const std::uint16_t* open[2];   ///< bit x of row y: the cell belongs to the unit; and of the columns
  const std::uint32_t* links[2];  ///< null: every diagonal between open cells is a link; else see TileMap::Links
  const std::uint16_t* across;    ///< by Side, bit i: a neighbour across is connected with the unit
  bool shared;                    ///< the tile has other units
  bool full;                      ///< all 256 cells belong to the unit
  bool fresh;                     ///< nobody has heard of it yet
  bool sweep_rows, sweep_columns;

  double keep, straight, slant;  ///< 1 - omega, omega beta, omega beta / sqrt 2
  double beta, threshold;        ///< changes below this share of what a neighbour has are not told

  /// Largest relative change of a cell in the last sweep as a power of two, times 2^20, about.
  std::int32_t change;
  double highest;  ///< activation along the sides
  struct Told {
    std::uint32_t cells;  ///< bit i: the neighbour across gains or loses more than the threshold
    std::int32_t share;   ///< how much of its activation at most, like `change`
    double highest;       ///< activation along the side
  } told[4];
};

/// The same functions for several processors: they give the same bits.
struct TileKernel {
  const char* name;
  /// Over-relaxed sweeps: rows from below and from above at once, through to the other side; then columns. And what the
  /// neighbours across each side feel of it.
  void (*relax)(TileScratch&);
  /// Largest relative error of a cell's equation; expects omega = 1.
  double (*residual)(TileScratch&);
};

/// Those that this processor can run, the fastest last; the first runs anywhere.
std::span<const TileKernel* const> tile_kernels();

}  // namespace meander
