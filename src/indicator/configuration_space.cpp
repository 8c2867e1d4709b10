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

}  // namespace

ConfigurationSpace::ConfigurationSpace(int width, int height, const GridFrame& frame, double reach)
    : known_(width, height, Known::nothing, frame),
      walls_near_(width, height, 0, frame),
      tiles_((width + kTile - 1) / kTile, (height + kTile - 1) / kTile) {
  if (!(frame.resolution > 0) || !(reach >= 0) || !(reach < 1000 * frame.resolution))
    fail("map: cells of a side > 0 and a reach of 0 to 1000 of them expected, got {} and {} m", frame.resolution,
         reach);
  const int cells = reach_ = static_cast<int>(reach / frame.resolution);
  const double most = reach * reach / (frame.resolution * frame.resolution);
  for (int y = -cells; y <= cells; ++y)
    for (int x = -cells; x <= cells; ++x)
      if (x * x + y * y <= most) disc_.push_back({x, y});
}

void ConfigurationSpace::set(Cell cell, Known known) {
  if (!known_.contains(cell) || known_[cell] == known) return;
  const int change = int{known == Known::wall} - int{known_[cell] == Known::wall};
  known_[cell] = known;
  ++version_;
  const int far = change == 0 ? 0 : reach_;
  touch({cell.x - far, cell.y - far}, {cell.x + far, cell.y + far});
  if (change == 0) return;
  for (const Cell offset : disc_) {
    const Cell near{cell.x + offset.x, cell.y + offset.y};
    if (walls_near_.contains(near)) walls_near_[near] += change;
  }
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
    if (known(beside) == Known::nothing && open(beside)) return true;
  return false;
}

}  // namespace meander
