// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/configuration_space.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

constexpr int kTile = 16;  ///< cells

/// Calls visit(tile) for the tiles that cells from `low` to `high` lie in.
template <class Tiles, class Visit>
void for_tiles(const Tiles& tiles, Cell low, Cell high, Visit visit) {
  const int right = std::min(high.x / kTile, tiles.width() - 1), top = std::min(high.y / kTile, tiles.height() - 1);
  for (int y = std::max(low.y, 0) / kTile; y <= top; ++y)
    for (int x = std::max(low.x, 0) / kTile; x <= right; ++x) visit(Cell{x, y});
}

/// Offsets of the cells within a distance, in cells.
std::vector<Cell> disc(double within) {
  const int cells = static_cast<int>(within);
  std::vector<Cell> offsets;
  for (int y = -cells; y <= cells; ++y)
    for (int x = -cells; x <= cells; ++x)
      if (x * x + y * y <= within * within) offsets.push_back({x, y});
  return offsets;
}

/// Adds to all cells at the offsets.
void add(Grid<std::int32_t>& counts, Cell cell, const std::vector<Cell>& offsets, int change) {
  if (change == 0) return;
  for (const Cell offset : offsets) {
    const Cell near{cell.x + offset.x, cell.y + offset.y};
    if (counts.contains(near)) counts[near] += change;
  }
}

int is_doubt(Known known) { return known == Known::wall || known == Known::suspected ? 1 : 0; }

}  // namespace

ConfigurationSpace::ConfigurationSpace(int width, int height, const GridFrame& frame, double reach, double room)
    : known_(width, height, Known::nothing, frame),
      walls_near_(width, height, 0, frame),
      doubts_near_(width, height, 0, frame),
      tiles_((width + kTile - 1) / kTile, (height + kTile - 1) / kTile) {
  if (!(frame.resolution > 0) || !(reach >= 0) || !(reach < 1000 * frame.resolution))
    fail("map: cells of a side > 0 and a reach of 0 to 1000 of them expected, got {} and {} m", frame.resolution,
         reach);
  reach_ = static_cast<int>(reach / frame.resolution);
  disc_ = disc(reach / frame.resolution);
  room_ = disc(room / frame.resolution);
  closed_near_ = Grid<std::int32_t>(width, height, static_cast<std::int32_t>(room_.size()), frame);
}

void ConfigurationSpace::set(Cell cell, Known known) {
  if (!known_.contains(cell) || known_[cell] == known) return;
  const Known before = known_[cell];
  const int walls = int{known == Known::wall} - int{before == Known::wall};
  const int doubts = is_doubt(known) - is_doubt(before);
  known_[cell] = known;
  ++version_;
  const int far = walls == 0 && doubts == 0 ? 0 : reach_;
  touch({cell.x - far, cell.y - far}, {cell.x + far, cell.y + far});
  add(walls_near_, cell, disc_, walls);
  add(doubts_near_, cell, disc_, doubts);
  add(closed_near_, cell, room_, int{before == Known::free} - int{known == Known::free});
}

void ConfigurationSpace::touch(Cell low, Cell high) {
  for_tiles(tiles_, low, high, [&](Cell tile) { tiles_[tile] = version_; });
}

std::uint64_t ConfigurationSpace::changed(Cell low, Cell high) const {
  std::uint64_t latest = 0;
  for_tiles(tiles_, low, high, [&](Cell tile) { latest = std::max(latest, tiles_[tile]); });
  return latest;
}

bool ConfigurationSpace::frontier(Cell cell) const {
  if (!free(cell)) return false;
  for (const Cell beside :
       {Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y + 1}, Cell{cell.x - 1, cell.y}, Cell{cell.x, cell.y - 1}})
    if (known(beside) == Known::nothing && !doubtful(beside)) return true;
  return false;
}

}  // namespace meander
