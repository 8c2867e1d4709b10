// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/cell_frame.hpp"
#include "geometry/nearest_hit.hpp"
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

  void cast(NearestHit& nearest, const Vec2& origin, const Vec2& direction) const;
  double distance(const Vec2& point, double most) const;
  bool inside(const Vec2& point) const;
  /// Calls wall(id, owner) and pole(owner) for all that the cells around the disc hold, for some of them repeatedly.
  template <class WallVisit, class PoleVisit>
  void around(const Vec2& center, double radius, WallVisit wall, PoleVisit pole) const {
    const int right = frame_.nearest_column(center.x() + radius), top = frame_.nearest_row(center.y() + radius);
    for (int row = frame_.nearest_row(center.y() - radius); row <= top; ++row)
      for (int column = frame_.nearest_column(center.x() - radius); column <= right; ++column) {
        const Cell& cell = cells_[frame_.index(column, row)];
        for (const WallPair* p = pairs_.begin(cell.walls); p != pairs_.end(cell.walls); ++p)
          for (const Tag& tag : p->tag)
            if (tag.id != kNoWall) wall(tag.id, tag.owner);
        for (const PoleCopy* p = poles_.begin(cell.poles); p != poles_.end(cell.poles); ++p) pole(p->owner);
      }
  }

 private:
  /// Two doubles: the vector width that every 64-bit processor has. Wider types than the processor's own are slow.
  using Lanes [[gnu::vector_size(16)]] = double;
  static constexpr std::uint32_t kNoWall = ~0u;

  struct Tag {
    std::uint32_t id = kNoWall;
    std::uint32_t owner : 31 = 0;
    std::uint32_t solid : 1 = 0;
  };
  /// Two walls of a cell side by side. An unused lane is NaN, which no test accepts.
  struct WallPair {
    Lanes ax, ay, bx, by;
    Tag tag[2];
  };
  struct PoleCopy {
    Disc disc;
    std::uint32_t owner = 0;
  };
  struct Cell {
    Run walls;  ///< in pairs; only the last pair may have an unused lane
    Run poles;
  };

  void push(Cell& cell, const Wall& wall, std::uint32_t id);
  void erase(Cell& cell, std::uint32_t id);
  void cast_in_cell(const Cell& cell, NearestHit& nearest, const Vec2& origin, const Vec2& direction) const;
  double squared_distance_in_cell(const Cell& cell, const Vec2& point, double best) const;
  bool touches_solid(const Cell& cell, const Vec2& point) const;

  CellFrame frame_;
  std::vector<Cell> cells_;
  std::vector<std::int32_t> depth_;  ///< solids around the cell's centre; true of the whole cell where it has no walls
  std::vector<std::int32_t> steps_;  ///< scratch of cover()
  RunPool<WallPair> pairs_;
  RunPool<PoleCopy> poles_;
};

}  // namespace meander
