// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "grid/grid.hpp"

namespace meander {

/// What views said of cells that have left the window, for when these come back: else each visit would prove anew what
/// the one before has proved.
class KeptViews {
 public:
  static constexpr std::int8_t kNone = -128;                       ///< no opinion
  static constexpr std::size_t kMostBytes = std::size_t{1} << 29;  ///< half a gigabyte

  explicit KeptViews(int views, std::size_t most_bytes = kMostBytes)
      : views_(static_cast<std::size_t>(views)), most_bytes_(most_bytes) {}

  std::int8_t opinion(Cell cell, int view) const;
  std::int32_t sum(Cell cell) const;
  void keep_opinion(Cell cell, int view, std::int8_t opinion);
  void keep_sum(Cell cell, std::int32_t sum) { tile(cell).sums[index(cell)] = sum; }
  /// Throws Error when no more can be kept.
  void check_room() const;
  void clear();
  std::size_t bytes() const { return bytes_; }

 private:
  static constexpr int kBits = 5;  ///< a tile has 2^kBits cells along a side
  static constexpr std::size_t kCells = std::size_t{1} << 2 * kBits;
  using Opinions = std::array<std::int8_t, kCells>;
  struct Tile {
    std::array<std::int32_t, kCells> sums{};
    std::vector<std::unique_ptr<Opinions>> opinions;  ///< by view; none of a view that saw none of the cells
  };
  using Place = std::pair<int, int>;

  static std::size_t index(Cell cell) {
    constexpr int kMask = (1 << kBits) - 1;
    return static_cast<std::size_t>((cell.y & kMask) << kBits | (cell.x & kMask));
  }
  static Place place(Cell cell) { return {cell.y >> kBits, cell.x >> kBits}; }
  const Tile* find(Cell cell) const;
  Tile& tile(Cell cell);

  std::size_t views_, most_bytes_, bytes_ = 0;
  std::map<Place, Tile> tiles_;
  mutable Place last_place_{};  ///< neighbours are asked for one after the other
  mutable const Tile* last_ = nullptr;
};

}  // namespace meander
