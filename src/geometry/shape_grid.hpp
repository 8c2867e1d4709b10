// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/cell_frame.hpp"
#include "geometry/nearest_hit.hpp"
#include "geometry/number_set.hpp"
#include "geometry/run_pool.hpp"
#include "geometry/shape_index.hpp"

namespace meander {

/// The cells of a ShapeIndex: which walls and poles touch which cell. Each cell holds copies of its walls' coordinates,
/// two walls side by side as the processor's vectors want them.
class ShapeGrid {
 public:
  explicit ShapeGrid(const CellFrame& frame);
  const CellFrame& frame() const { return frame_; }

  void add(const Wall& wall, std::uint32_t id);
  void remove(const Wall& wall, std::uint32_t id);
  void add(const Pole& pole);
  void remove(const Pole& pole);
  /// Adds `sign` to the depth of every cell whose centre is inside the ring of walls.
  void cover(std::span<const Wall> walls, const Box& box, int sign);

  NearestHit cast(NearestHit nearest, const Wall* walls, const Vec2& origin, const Vec2& direction) const;
  double distance(const Wall* walls, const Vec2& point, double most) const;
  bool inside(const Wall* walls, const Vec2& point) const;
  /// Calls wall(id) and pole(owner) for all that the cells around the disc hold, for some of them repeatedly.
  template <class WallVisit, class PoleVisit>
  void around(const Vec2& center, double radius, WallVisit wall, PoleVisit pole) const {
    const int right = frame_.nearest_column(center.x() + radius), top = frame_.nearest_row(center.y() + radius);
    for (int row = frame_.nearest_row(center.y() - radius); row <= top; ++row)
      for (int column = frame_.nearest_column(center.x() - radius); column <= right; ++column) {
        const Cell& cell = cell_at(column, row);
        for_each_wall(cell, wall);
        for (const PoleCopy& copy : poles_.items(cell.poles)) pole(copy.owner);
      }
  }

 private:
  /// Four floats: a vector that every 64-bit processor has. Wider types than the processor's own are slow.
  using Lanes [[gnu::vector_size(16)]] = float;
  static constexpr std::size_t kLanes = 4;
  static Lanes lanes(double x);
  static constexpr std::uint32_t kNoWall = ~0u;

  /// Parts of four walls, from (ax, ay) to (bx, by) from the cell's corner. Unused lanes are NaN, which no test
  /// accepts.
  struct WallBlock {
    Lanes ax, ay, bx, by;
    std::uint32_t id[kLanes];
  };
  struct PoleCopy {
    Disc disc;
    std::uint32_t owner = 0;
  };
  struct Cell {
    PoolRun walls;  ///< blocks; only the last may have unused lanes, at its end
    PoolRun poles;
  };

  template <class Visit>
  void for_each_wall(const Cell& cell, Visit visit) const {
    for (const WallBlock& block : blocks_.items(cell.walls))
      for (const std::uint32_t id : block.id)
        if (id != kNoWall) visit(id);
  }
  static bool empty(const Cell& cell) { return cell.walls.count == 0 && cell.poles.count == 0; }
  const Cell& cell_at(int column, int row) const { return cells_[frame_.index(column, row)]; }
  void push(std::size_t index, const Vec2& a, const Vec2& b, std::uint32_t id);
  void erase(std::size_t index, std::uint32_t id);
  double squared_distance(const Cell& cell, const Wall* walls, const Vec2& point, double best) const;
  bool touches_solid(const Cell& cell, const Wall* walls, const Vec2& point) const;

  CellFrame frame_;
  std::vector<Cell> cells_;
  NumberSet occupied_;               ///< indices of cells that hold something
  std::vector<std::int32_t> depth_;  ///< solids around the cell's centre; true of the whole cell where it has no walls
  std::vector<std::int32_t> steps_;  ///< scratch of cover()
  RunPool<WallBlock> blocks_;
  RunPool<PoleCopy> poles_;
};

}  // namespace meander
