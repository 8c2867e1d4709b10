// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <vector>

#include "grid/grid.hpp"

namespace meander {

/// What a map knows of a cell. Where a wall is suspected not enough speaks for one to stop at, but enough not to expect
/// anything behind.
enum class Known : std::uint8_t { nothing, free, wall, suspected };

/// Where the centre of a round robot can be, by a map that is being made: kept up to date cell by cell, at a cost only
/// where a wall comes or goes. Beyond the rim of the map nothing is passable.
class ConfigurationSpace {
 public:
  /// `reach` is the robot's radius and what it keeps from walls; what is within `room` crowds it [m]. Nothing is known
  /// at first.
  ConfigurationSpace(int width, int height, const GridFrame& frame, double reach, double room = 0);

  void set(Cell cell, Known known);

  Known known(Cell cell) const { return known_.at(cell, Known::wall); }
  /// A wall is within reach of the cell's centre.
  bool blocked(Cell cell) const { return walls_near_.at(cell, 1) > 0; }
  /// The robot's centre can be here, for all that is known.
  bool free(Cell cell) const { return known(cell) == Known::free && !blocked(cell); }
  /// Nothing speaks against the robot's being here.
  bool open(Cell cell) const { return !blocked(cell); }
  /// A wall is within reach of the cell's centre, or suspected there.
  bool doubtful(Cell cell) const { return doubts_near_.at(cell, 1) > 0; }
  /// How much of the room around the cell's centre is not known to be free: from 0, nothing, to `all`.
  int crowded(Cell cell, int all) const { return all * closed_near_.at(cell, 0) / static_cast<int>(room_.size()); }
  /// Free, and beside it is a cell of which nothing is known, no wall even suspected: an opening narrower than the
  /// robot has none.
  bool frontier(Cell cell) const;

  /// Counts changes; what was computed from cells that have not changed since can be kept.
  std::uint64_t version() const { return version_; }
  /// Version of the latest change of what is known of a cell, or of whether it is blocked, from `low` to `high` (or a
  /// little beyond).
  std::uint64_t changed(Cell low, Cell high) const;

  int width() const { return known_.width(); }
  int height() const { return known_.height(); }
  const GridFrame& frame() const { return known_.frame; }
  double resolution() const { return known_.frame.resolution; }

 private:
  void touch(Cell low, Cell high);

  Grid<Known> known_;
  Grid<std::int32_t> walls_near_;   ///< walls within reach of each cell
  Grid<std::int32_t> doubts_near_;  ///< those and suspected ones
  Grid<std::int32_t> closed_near_;  ///< cells within its room that are not known to be free
  std::vector<Cell> disc_, room_;   ///< offsets within reach, within the room
  int reach_ = 0;                   ///< in cells
  std::uint64_t version_ = 0;
  Grid<std::uint64_t> tiles_;  ///< versions of the latest change, by squares of cells
};

}  // namespace meander
