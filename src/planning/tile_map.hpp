// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "planning/problem.hpp"
#include "planning/tile_kernel.hpp"

namespace meander {

/// Sixteen bits for each row (or column) of a tile.
using TileBits = std::array<std::uint16_t, kTile>;

/// The cells of one tile that hang together. They are at most 128 steps from each other, so one exponent serves them
/// all, whatever the activation of other units in the same tile.
struct TileUnit {
  static constexpr std::int32_t kAsleep = std::numeric_limits<std::int32_t>::min();

  std::int32_t slot = 0;
  std::int32_t exponent = kAsleep;  ///< activation is the stored number times 2^exponent; a multiple of 512
  std::int32_t key = std::numeric_limits<std::int32_t>::max();  ///< place in the queue
  std::int32_t links = -1;  ///< of TileMap::links; -1: every diagonal between open cells is a link
  std::int32_t curve = -1;  ///< where tanh is not the identity: what keeps its gains
  std::uint8_t sides = 0;   ///< where something changed: bit TileScratch::Side
  std::uint8_t colour = 0;  ///< whether the column and the row of its tile are odd: units of one colour are apart
  bool full = false;        ///< all 256 cells
  bool touched = false;     ///< relaxed since the equations were checked last
  bool fresh = false;       ///< holds a target of which nobody has heard yet
  std::uint16_t size = 0;   ///< cells; 0: an edit has put others in its place
  std::int32_t hops = 0;    ///< units on the way to the nearest target, where edits are followed
  TileBits rows{}, columns{};
  std::array<std::uint16_t, 4> across{};  ///< by Side: where units of the neighbouring tile are connected with it
};

/// The map cut into tiles of 16 x 16 cells. Tiles without an open cell share slot 0, which also is the rim.
struct TileMap {
  static constexpr int kCells = kTile * kTile;
  /// Bit p of rows[r]: the cells p - 1 and p of the rows r - 1 and r are all open, so that both diagonals are links.
  struct Links {
    std::array<std::uint32_t, kTile + 1> rows{}, columns{};
  };

  struct Range {
    std::int32_t first = 0, end = 0;
  };

  Corners corners = Corners::keep;
  int across = 0;  ///< tiles in a row, with the rim
  int up = 0;
  std::size_t cell_count = 0;      ///< open cells
  std::vector<std::int32_t> slot;  ///< of each tile
  std::vector<std::int32_t> tile;  ///< of each slot
  std::vector<Range> units_in;     ///< of each slot
  std::vector<TileBits> open;      ///< of each slot: the open cells, row by row
  std::vector<TileUnit> units;     ///< those of a slot side by side
  std::vector<Links> links;
  std::vector<TileCells> cells;  ///< of each slot

  TileCells& cells_of(std::int32_t s) { return cells[static_cast<std::size_t>(s)]; }
  const TileCells& cells_of(std::int32_t s) const { return cells[static_cast<std::size_t>(s)]; }
  /// The slot beyond a side of another, by TileScratch::Side; and beyond a corner.
  std::int32_t slot_beside(std::int32_t s, int side) const {
    const std::int32_t steps[4] = {-across, across, -1, 1};
    return slot[static_cast<std::size_t>(tile[static_cast<std::size_t>(s)] + steps[side])];
  }
  std::int32_t slot_at_corner(std::int32_t s, int c) const {
    const std::int32_t step = ((c & 2) != 0 ? across : -across) + ((c & 1) != 0 ? 1 : -1);
    return slot[static_cast<std::size_t>(tile[static_cast<std::size_t>(s)] + step)];
  }
  template <class Visit>
  void for_each_unit(std::int32_t s, Visit visit) const {
    const Range range = units_in[static_cast<std::size_t>(s)];
    for (std::int32_t u = range.first; u < range.end; ++u) visit(u, units[static_cast<std::size_t>(u)]);
  }
  std::int32_t tile_of(Cell cell) const { return (cell.y / kTile + 1) * across + cell.x / kTile + 1; }
  /// The unit that holds bit x of row y of the slot; -1: none.
  std::int32_t unit_at(std::int32_t s, int x, int y) const {
    const Range range = units_in[static_cast<std::size_t>(s)];
    for (std::int32_t u = range.first; u < range.end; ++u)
      if ((units[static_cast<std::size_t>(u)].rows[static_cast<std::size_t>(y)] >> x & 1) != 0) return u;
    return -1;
  }
};

/// Is the unit's cell in corner c connected with the tile across? Bit 0 of c: right, bit 1: above.
inline bool corner_open(const TileMap& map, const TileUnit& unit, int c) {
  const bool right = (c & 1) != 0, up = (c & 2) != 0;
  if ((unit.rows[up ? kTile - 1 : 0] >> (right ? kTile - 1 : 0) & 1) == 0) return false;
  return unit.links < 0 ||
         (map.links[static_cast<std::size_t>(unit.links)].rows[up ? kTile : 0] >> (right ? kTile : 0) & 1) != 0;
}

/// The unit's cells along one of its sides.
inline std::uint32_t edge_bits(const TileUnit& unit, int side) {
  switch (side) {
    case TileScratch::below:
      return unit.rows.front();
    case TileScratch::above:
      return unit.rows.back();
    case TileScratch::left:
      return unit.columns.front();
    default:
      return unit.columns.back();
  }
}

/// The cells of `other`, across the side, if any is connected with one of the unit. Where corners are kept every
/// diagonal connection has a straight one beside it.
inline std::uint32_t bits_across(const TileMap& map, const TileUnit& unit, int side, const TileUnit& other) {
  const std::uint32_t own = edge_bits(unit, side), bits = edge_bits(other, side ^ 1);
  const std::uint32_t reach = map.corners == Corners::cut ? own | own << 1 | own >> 1 : own;
  return (reach & bits) != 0 ? bits : 0;
}

/// Calls visit(number) for all units that are connected with this one, some of them twice.
template <class Visit>
void for_each_neighbour(const TileMap& map, const TileUnit& unit, Visit visit) {
  for (int side = 0; side < 4; ++side)
    map.for_each_unit(map.slot_beside(unit.slot, side), [&](std::int32_t u, const TileUnit& other) {
      if (bits_across(map, unit, side, other) != 0) visit(u);
    });
  for (int c = 0; c < 4; ++c) {
    if (!corner_open(map, unit, c)) continue;
    const std::int32_t u =
        map.unit_at(map.slot_at_corner(unit.slot, c), (c & 1) != 0 ? 0 : kTile - 1, (c & 2) != 0 ? 0 : kTile - 1);
    if (u >= 0) visit(u);
  }
}

TileMap tile_map(const PlanningProblem& problem, const Work& work = {});

/// The tile's units anew, from the map as it is now. They keep what activation their cells had. Their connections, and
/// those of the tiles around, are to be found anew by reconnect().
void recut(TileMap& map, const PlanningProblem& problem, std::int32_t tile);
void reconnect(TileMap& map, std::int32_t tile);
/// Forgets units that have been replaced: all others get other numbers.
void compact(TileMap& map);

}  // namespace meander
