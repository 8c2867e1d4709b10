// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <map>
#include <memory>
#include <span>
#include <utility>

#include "grid/grid.hpp"

namespace meander {

/// [CN] section 5, future work 3: the map of everywhere. It grows by tiles and takes what each scan added to the local
/// map, never the local map's sums, so nothing counts twice.
class GlobalMap {
 public:
  GlobalMap(double resolution, float limit) : resolution_(resolution), limit_(limit) {}

  /// Evidence for a square of cells, row by row from `low`. Throws Error when the map would be larger than kMostTiles.
  void add(Cell low, int size, std::span<const float> increments);
  /// Throws what add() would throw.
  void check_room(Cell low, int size) const;
  /// 0: unknown.
  float log_odds(Cell cell) const;
  Cell cell(const Vec2& point) const { return GridFrame{resolution_, {}}.cell(point); }
  double resolution() const { return resolution_; }
  void clear() { tiles_.clear(); }

  /// The least rectangle with all known cells, bottom row first, placed in the odometry frame; empty when nothing is
  /// known. Throws Error when it has more than kMostCells.
  Grid<float> log_odds() const;
  std::size_t bytes() const { return tiles_.size() * sizeof(Tile); }

  static constexpr std::size_t kMostTiles = 8192;  ///< half a gigabyte
  static constexpr double kMostCells = 1e8;

 private:
  static constexpr int kTile = 128;  ///< cells along a side
  using Tile = std::array<float, kTile * kTile>;
  Tile& tile(int column, int row);

  double resolution_;
  float limit_;
  std::map<std::pair<int, int>, std::unique_ptr<Tile>> tiles_;  ///< by row and column
};

}  // namespace meander
