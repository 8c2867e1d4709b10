// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/tile_map.hpp"

#include <algorithm>
#include <bit>

namespace meander {
namespace {

TileBits open_cells(const Grid<std::uint8_t>& blocked, int left, int low) {
  TileBits open{};
  const int width = std::min(kTile, blocked.width() - left), height = std::min(kTile, blocked.height() - low);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row =
        &blocked.cells()[static_cast<std::size_t>(low + y) * static_cast<std::size_t>(blocked.width()) +
                         static_cast<std::size_t>(left)];
    unsigned bits = 0;
    for (int x = 0; x < width; ++x) bits |= static_cast<unsigned>(row[x] == 0) << x;
    open[static_cast<std::size_t>(y)] = static_cast<std::uint16_t>(bits);
  }
  return open;
}

bool any(const TileBits& bits) {
  return std::any_of(bits.begin(), bits.end(), [](std::uint16_t row) { return row != 0; });
}

bool all(const TileBits& bits) {
  return std::all_of(bits.begin(), bits.end(), [](std::uint16_t row) { return row == 0xffff; });
}

/// The cells of `open` that hang together with its first.
TileBits first_component(const TileBits& open, Corners corners) {
  TileBits part{};
  const auto first = static_cast<std::size_t>(
      std::find_if(open.begin(), open.end(), [](std::uint16_t r) { return r != 0; }) - open.begin());
  part[first] = static_cast<std::uint16_t>(open[first] & -open[first]);
  const auto spread = [&](std::size_t r, std::size_t from) {  // into row r
    const unsigned near = part[from], wide = near | near << 1 | near >> 1;
    unsigned bits = part[r] | ((corners == Corners::cut ? wide : near) & open[r]);
    for (unsigned old = 0; bits != old;) old = bits, bits = (bits | bits << 1 | bits >> 1) & open[r];
    const bool grown = bits != part[r];
    part[r] = static_cast<std::uint16_t>(bits);
    return grown;
  };
  spread(first, first);
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t r = 1; r < kTile; ++r) grown = spread(r, r - 1) || grown;
    for (std::size_t r = kTile - 1; r-- > 0;) grown = spread(r, r + 1) || grown;
  }
  return part;
}

TileBits turned(const TileBits& rows) {
  TileBits columns{};
  for (std::size_t y = 0; y < kTile; ++y)
    for (unsigned rest = rows[y]; rest != 0; rest &= rest - 1)
      columns[static_cast<std::size_t>(std::countr_zero(rest))] |= static_cast<std::uint16_t>(1u << y);
  return columns;
}

void add_units(TileMap& map, std::int32_t s, Corners corners) {
  TileBits rest = map.open[static_cast<std::size_t>(s)];
  if (all(rest)) {
    map.units.push_back({.slot = s, .full = true, .size = TileMap::kCells, .rows = rest, .columns = rest});
    return;
  }
  while (any(rest)) {
    const TileBits part = first_component(rest, corners);
    for (std::size_t r = 0; r < kTile; ++r) rest[r] = static_cast<std::uint16_t>(rest[r] & ~part[r]);
    int size = 0;
    for (const std::uint16_t row : part) size += std::popcount(row);
    map.units.push_back({.slot = s, .size = static_cast<std::uint16_t>(size), .rows = part, .columns = turned(part)});
  }
}

/// Row r of the unit, -1 and 16 included, with a cell of the tiles beside it to either side: 18 bits.
std::uint32_t wide_row(const TileMap& map, const TileUnit& unit, int r) {
  const std::int32_t t = map.tile[static_cast<std::size_t>(unit.slot)];
  const int row = r < 0 ? kTile - 1 : r % kTile;
  const std::int32_t middle = t + (r < 0 ? -map.across : r >= kTile ? map.across : 0);
  const auto bits = [&](std::int32_t tile) -> std::uint32_t {
    return map.open[static_cast<std::size_t>(map.slot[static_cast<std::size_t>(tile)])][static_cast<std::size_t>(row)];
  };
  const std::uint32_t own = middle == t ? unit.rows[static_cast<std::size_t>(row)] : bits(middle);
  return own << 1 | bits(middle - 1) >> (kTile - 1) | (bits(middle + 1) & 1) << (kTile + 1);
}

/// Notes where diagonals are closed by a corner, if any is.
void add_links(TileMap& map, TileUnit& unit) {
  TileMap::Links links;
  bool closed = false;
  std::uint32_t lower = wide_row(map, unit, -1);
  for (int r = 0; r <= kTile; ++r) {
    const std::uint32_t upper = wide_row(map, unit, r);
    const std::uint32_t block = lower & lower >> 1 & upper & upper >> 1;
    closed = closed || (((lower & upper >> 1) | (lower >> 1 & upper)) & ~block) != 0;
    links.rows[static_cast<std::size_t>(r)] = block & 0x1ffff;
    lower = upper;
  }
  if (!closed) return;
  for (std::size_t r = 0; r <= kTile; ++r)
    for (std::size_t p = 0; p <= kTile; ++p) links.columns[p] |= (links.rows[r] >> p & 1) << r;
  unit.links = static_cast<std::int32_t>(map.links.size());
  map.links.push_back(links);
}

void add_reach(const TileMap& map, TileUnit& unit) {
  for (int side = 0; side < 4; ++side)
    map.for_each_unit(map.slot_beside(unit.slot, side), [&](std::int32_t, const TileUnit& other) {
      unit.across[static_cast<std::size_t>(side)] |= static_cast<std::uint16_t>(bits_across(map, unit, side, other));
    });
}

}  // namespace

TileMap tile_map(const PlanningProblem& problem, const Work& work) {
  const Grid<std::uint8_t>& blocked = problem.blocked;
  TileMap map;
  map.corners = problem.corners;
  map.across = (blocked.width() + kTile - 1) / kTile + 2;
  map.up = (blocked.height() + kTile - 1) / kTile + 2;
  map.slot.assign(static_cast<std::size_t>(map.across) * static_cast<std::size_t>(map.up), 0);
  map.tile = {0};
  map.open = {TileBits{}};
  map.first_unit = {0};
  for (int y = 1; y < map.up - 1; ++y) {
    work.poll();
    for (int x = 1; x < map.across - 1; ++x) {
      const TileBits open = open_cells(blocked, (x - 1) * kTile, (y - 1) * kTile);
      if (!any(open)) continue;
      const auto s = static_cast<std::int32_t>(map.tile.size());
      map.slot[static_cast<std::size_t>(y * map.across + x)] = s;
      map.tile.push_back(y * map.across + x);
      map.open.push_back(open);
      map.first_unit.push_back(static_cast<std::int32_t>(map.units.size()));
      add_units(map, s, problem.corners);
    }
  }
  map.first_unit.push_back(static_cast<std::int32_t>(map.units.size()));
  if (problem.corners == Corners::keep)
    for (TileUnit& unit : map.units) add_links(map, unit);
  for (TileUnit& unit : map.units) {
    map.cell_count += unit.size;
    add_reach(map, unit);
  }
  map.cells.assign(map.tile.size(), {});
  return map;
}

}  // namespace meander
