// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/tile_map.hpp"

#include <algorithm>
#include <bit>
#include <utility>

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

void add_parts(TileMap& map, std::int32_t s, Corners corners) {
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

void add_units(TileMap& map, std::int32_t s) {
  TileMap::Range& range = map.units_in[static_cast<std::size_t>(s)];
  range.first = static_cast<std::int32_t>(map.units.size());
  add_parts(map, s, map.corners);
  range.end = static_cast<std::int32_t>(map.units.size());
  const std::int32_t t = map.tile[static_cast<std::size_t>(s)];
  for (std::int32_t u = range.first; u < range.end; ++u)
    map.units[static_cast<std::size_t>(u)].colour =
        static_cast<std::uint8_t>(t % map.across % 2 + t / map.across % 2 * 2);
}

std::int32_t add_slot(TileMap& map, std::int32_t t) {
  const auto s = static_cast<std::int32_t>(map.tile.size());
  map.slot[static_cast<std::size_t>(t)] = s;
  map.tile.push_back(t);
  map.open.emplace_back();
  map.units_in.emplace_back();
  return s;
}

TileBits open_in_tile(const TileMap& map, const Grid<std::uint8_t>& blocked, std::int32_t t) {
  return open_cells(blocked, (t % map.across - 1) * kTile, (t / map.across - 1) * kTile);
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
  const std::int32_t old = std::exchange(unit.links, -1);
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
  unit.links = old >= 0 ? old : static_cast<std::int32_t>(map.links.size());
  if (old < 0) map.links.emplace_back();
  map.links[static_cast<std::size_t>(unit.links)] = links;
}

void add_reach(const TileMap& map, TileUnit& unit) {
  unit.across = {};
  for (int side = 0; side < 4; ++side)
    map.for_each_unit(map.slot_beside(unit.slot, side), [&](std::int32_t, const TileUnit& other) {
      unit.across[static_cast<std::size_t>(side)] |= static_cast<std::uint16_t>(bits_across(map, unit, side, other));
    });
}

/// What the unit's cells had as cells of the units that were there before, in the highest exponent of those.
void inherit(TileUnit& unit, const std::vector<TileUnit>& old, const TileCells& values, TileCells& cells) {
  const auto common = [&](const TileUnit& other, auto visit) {
    if (other.exponent == TileUnit::kAsleep) return;
    for (std::size_t r = 0; r < kTile; ++r)
      for (std::uint32_t rest = unit.rows[r] & other.rows[r]; rest != 0; rest &= rest - 1)
        visit(static_cast<int>(r), std::countr_zero(rest));
  };
  for (const TileUnit& other : old)
    common(other, [&](int, int) {
      unit.exponent = std::max(unit.exponent, other.exponent);
      unit.hops = other.hops;
    });
  for (const TileUnit& other : old)
    common(other, [&](int r, int x) { cells.cell[r][x] = other.exponent == unit.exponent ? values.cell[r][x] : 0; });
  for (int r = 0; r < kTile; ++r) cells.side[0][r] = cells.cell[r][0], cells.side[1][r] = cells.cell[r][kTile - 1];
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
  map.units_in = {{}};
  for (int y = 1; y < map.up - 1; ++y) {
    work.poll();
    for (int x = 1; x < map.across - 1; ++x) {
      const std::int32_t t = y * map.across + x;
      const TileBits open = open_in_tile(map, blocked, t);
      if (!any(open)) continue;
      const std::int32_t s = add_slot(map, t);
      map.open[static_cast<std::size_t>(s)] = open;
      add_units(map, s);
    }
  }
  if (problem.corners == Corners::keep)
    for (TileUnit& unit : map.units) add_links(map, unit);
  for (TileUnit& unit : map.units) {
    map.cell_count += unit.size;
    add_reach(map, unit);
  }
  map.cells.assign(map.tile.size(), {});
  return map;
}

void recut(TileMap& map, const PlanningProblem& problem, std::int32_t tile) {
  std::int32_t s = map.slot[static_cast<std::size_t>(tile)];
  const TileBits open = open_in_tile(map, problem.blocked, tile);
  if (s == 0) {
    if (!any(open)) return;
    s = add_slot(map, tile);
    map.cells.emplace_back();
  }
  const auto slot = static_cast<std::size_t>(s);
  const TileMap::Range before = map.units_in[slot];
  const std::vector<TileUnit> old(map.units.begin() + before.first, map.units.begin() + before.end);
  for (std::int32_t u = before.first; u < before.end; ++u) map.units[static_cast<std::size_t>(u)] = {.slot = s};
  map.open[slot] = open;
  add_units(map, s);
  const TileCells values = std::exchange(map.cells[slot], {});
  for (std::int32_t u = map.units_in[slot].first; u < map.units_in[slot].end; ++u)
    inherit(map.units[static_cast<std::size_t>(u)], old, values, map.cells[slot]);
}

void reconnect(TileMap& map, std::int32_t tile) {
  const TileMap::Range range = map.units_in[static_cast<std::size_t>(map.slot[static_cast<std::size_t>(tile)])];
  for (std::int32_t u = range.first; u < range.end; ++u) {
    TileUnit& unit = map.units[static_cast<std::size_t>(u)];
    if (map.corners == Corners::keep) add_links(map, unit);
    add_reach(map, unit);
  }
}

void compact(TileMap& map) {
  std::vector<TileUnit> units;
  std::vector<TileMap::Links> links;
  for (TileMap::Range& range : map.units_in) {
    const auto first = static_cast<std::int32_t>(units.size());
    for (std::int32_t u = range.first; u < range.end; ++u) {
      TileUnit& unit = units.emplace_back(map.units[static_cast<std::size_t>(u)]);
      if (unit.links < 0) continue;
      links.push_back(map.links[static_cast<std::size_t>(unit.links)]);
      unit.links = static_cast<std::int32_t>(links.size()) - 1;
    }
    range = {first, static_cast<std::int32_t>(units.size())};
  }
  map.units = std::move(units);
  map.links = std::move(links);
}

}  // namespace meander
