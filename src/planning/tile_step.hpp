// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>

#include "planning/tile_map.hpp"

namespace meander {

/// What a unit that was relaxed has to tell another, or itself.
struct TileNews {
  std::int32_t unit;
  std::int32_t key;       ///< the less, the more urgent
  std::uint8_t sides;     ///< where the other should look: bits TileScratch::Side
  bool steep;             ///< the other lies so near to a target that tanh bends
  std::int32_t exponent;  ///< for the other, if it is asleep
};

/// All news of one unit: four sides and corners with up to eight units each, and itself.
struct TileOutcome {
  std::array<TileNews, 4 * kTile / 2 + 5> news;
  int count = 0;
  std::int64_t relaxations = 0;

  void add(const TileNews& one) { news[static_cast<std::size_t>(count++)] = one; }
};

/// tanh(u) / u of a unit's cells, 0 for targets; and how much of its own activation each keeps.
struct alignas(64) TileCurve {
  double gain[kTile][kTile];
  double hold[kTile][kTile];
};

/// The equations of one unit after the other.
struct TileStep {
  TileMap& map;
  const TileKernel& kernel;
  std::vector<TileCurve>& curves;
  double beta;        ///< of neighbours in a row or column; those on diagonals have beta / sqrt 2
  double omega;       ///< over-relaxation
  double bent_above;  ///< activation up to here has u for tanh(u) = u (1 - u^2 / 3): a 75th of the tolerance

  /// Changes below this share are not told.
  void relax(std::int32_t unit, double threshold, TileScratch& scratch, TileOutcome& outcome) const;
  /// Largest relative error of a cell's equation.
  double residual(std::int32_t unit, TileScratch& scratch) const;

  /// The key under which the unit waits for a change of all it has.
  std::int32_t place(std::int32_t unit) const;

  /// Has it activation for which tanh bends?
  bool is_steep(const TileUnit& unit) const;
  /// Brings the unit to exponent 0.
  void rebase(TileUnit& unit) const;

 private:
  /// Neighbours whose exponents are higher.
  struct Above {
    std::int32_t blocks = 0;
    double highest = 0;
  };
  void gather(TileUnit& unit, TileScratch& scratch) const;
  bool gather_surroundings(TileUnit& unit, TileScratch& scratch) const;
  const double* gather_edge(const TileUnit& unit, int side, double* brought, Above& above) const;
  double gather_corner(const TileUnit& unit, int c, Above& above) const;
  double factor_of(const TileUnit& unit, const TileUnit& other, double value, Above& above) const;
  void scale(TileUnit& unit, int blocks) const;
  double highest_of(const TileUnit& unit) const;
  void bend(TileUnit& unit, const TileScratch& scratch) const;
  void tell(const TileUnit& unit, std::int32_t other, double value, int change_bits, int sides,
            TileOutcome& outcome) const;
  void tell_side(const TileUnit& unit, int side, const TileScratch& scratch, TileOutcome& outcome) const;
  void tell_corner(const TileUnit& unit, int c, const TileScratch& scratch, TileOutcome& outcome) const;
};

}  // namespace meander
