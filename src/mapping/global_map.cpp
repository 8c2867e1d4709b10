// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/global_map.hpp"

#include <algorithm>

#include "mapping/log_odds.hpp"

namespace meander {
namespace {

int floored(int value, int size) { return value >= 0 ? value / size : -((-value - 1) / size) - 1; }

}  // namespace

GlobalMap::Tile& GlobalMap::tile(int column, int row) {
  auto& tile = tiles_[{row, column}];
  if (!tile) tile = std::make_unique<Tile>(Tile{});
  return *tile;
}

void GlobalMap::check_room(Cell low, int size) const {
  std::size_t tiles = tiles_.size();
  for (int row = floored(low.y, kTile); row <= floored(low.y + size - 1, kTile); ++row)
    for (int column = floored(low.x, kTile); column <= floored(low.x + size - 1, kTile); ++column)
      tiles += tiles_.contains({row, column}) ? 0 : 1;
  if (tiles > kMostTiles)
    fail<Error>("the global map is full: {} m^2 are kept",
                static_cast<double>(kMostTiles) * kTile * kTile * resolution_ * resolution_);
}

void GlobalMap::add(Cell low, int size, std::span<const float> increments) {
  check_room(low, size);
  for (int row = floored(low.y, kTile); row <= floored(low.y + size - 1, kTile); ++row)
    for (int column = floored(low.x, kTile); column <= floored(low.x + size - 1, kTile); ++column) {
      Tile& to = tile(column, row);
      const int x0 = std::max(low.x, column * kTile), x1 = std::min(low.x + size, (column + 1) * kTile);
      const int y0 = std::max(low.y, row * kTile), y1 = std::min(low.y + size, (row + 1) * kTile);
      for (int y = y0; y < y1; ++y)
        add_evidence(to.data() + (y - row * kTile) * kTile + (x0 - column * kTile),
                     increments.data() + static_cast<std::ptrdiff_t>(y - low.y) * size + (x0 - low.x),
                     static_cast<std::size_t>(x1 - x0), limit_);
    }
}

float GlobalMap::log_odds(Cell cell) const {
  const int column = floored(cell.x, kTile), row = floored(cell.y, kTile);
  const auto found = tiles_.find({row, column});
  if (found == tiles_.end()) return 0;
  return (*found->second)[static_cast<std::size_t>((cell.y - row * kTile) * kTile + (cell.x - column * kTile))];
}

Grid<float> GlobalMap::log_odds() const {
  Cell low{1 << 30, 1 << 30}, high{-(1 << 30), -(1 << 30)};
  const auto for_each_known = [this](auto visit) {
    for (const auto& [at, tile] : tiles_)
      for (int i = 0; i < kTile * kTile; ++i)
        if (const float value = (*tile)[static_cast<std::size_t>(i)]; value != 0)
          visit(Cell{at.second * kTile + i % kTile, at.first * kTile + i / kTile}, value);
  };
  for_each_known([&](Cell c, float) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y)};
  });
  if (high.x < low.x) return {};
  const double width = 1.0 + high.x - low.x, height = 1.0 + high.y - low.y;
  if (width * height > kMostCells)
    fail<Error>("the global map spans {} x {} cells, too many for one grid", width, height);
  Grid<float> all(static_cast<int>(width), static_cast<int>(height), 0,
                  {resolution_, {low.x * resolution_, low.y * resolution_, 0}});
  for_each_known([&](Cell c, float value) { all[{c.x - low.x, c.y - low.y}] = value; });
  return all;
}

}  // namespace meander
