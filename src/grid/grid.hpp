// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <vector>

#include "base/error.hpp"
#include "geometry/pose.hpp"

namespace meander {

/// Column and row of a grid; (0, 0) is the lower left cell.
struct Cell {
  int x = 0;
  int y = 0;
  bool operator==(const Cell&) const = default;
};

/// Where a grid lies: `origin` is the pose of the lower left corner of cell (0, 0), `resolution` the side of a cell
/// [m].
struct GridFrame {
  double resolution = 1;
  Pose2 origin;

  Vec2 center(Cell cell) const { return origin * Vec2((cell.x + 0.5) * resolution, (cell.y + 0.5) * resolution); }
  /// The point in units of cells from the lower left corner.
  Vec2 in_cells(const Vec2& point) const { return inverse(origin) * point / resolution; }
  /// The cell that contains the point; may lie outside the grid.
  Cell cell(const Vec2& point) const {
    const Vec2 p = in_cells(point).cwiseMax(-kFarthestCell).cwiseMin(kFarthestCell);
    return {static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))};
  }
  /// Points beyond are taken to lie in the last cell.
  static constexpr double kFarthestCell = 1 << 30;
  bool operator==(const GridFrame&) const = default;
};

/// Row-major array of cells, bottom row first.
template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(int width, int height, const T& fill = T{}, GridFrame frame = {})
      : frame(frame), width_(width), height_(height) {
    if (width < 0 || height < 0) fail("grid: width and height >= 0 expected, got {} x {}", width, height);
    cells_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_; }
  typename std::vector<T>::reference operator[](Cell c) { return cells_[index(c)]; }
  typename std::vector<T>::const_reference operator[](Cell c) const { return cells_[index(c)]; }
  /// The cell's value, or `outside` beyond the rim.
  T at(Cell c, const T& outside) const { return contains(c) ? T(cells_[index(c)]) : outside; }
  std::vector<T>& cells() { return cells_; }
  const std::vector<T>& cells() const { return cells_; }
  bool operator==(const Grid&) const = default;

  GridFrame frame;

 private:
  std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(c.x);
  }
  int width_ = 0;
  int height_ = 0;
  std::vector<T> cells_;
};

}  // namespace meander
