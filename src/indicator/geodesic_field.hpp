// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "indicator/configuration_space.hpp"

namespace meander {

/// What a way costs: its length, or more where little room is around it, so that it keeps to the middle.
enum class WayCost { length, room };

/// Lengths of the ways from a cell through free cells, up to a limit. Steps along the rows count 5 fifths of a cell,
/// diagonal ones 7; a diagonal step needs both cells beside it. Keeps its arrays from one use to the next; they are no
/// larger than the map.
class GeodesicField {
 public:
  /// `limit` in metres. Through cells of which nothing is known as well where `unknown` is true, through none that is
  /// marked in `closed`.
  void spread(const ConfigurationSpace& space, Cell start, double limit, bool unknown = false,
              WayCost cost = WayCost::length) {
    spread(space, std::span(&start, 1), limit, unknown, cost);
  }
  /// From the nearest of several cells. With `until` it ends shortly beyond that cell: nothing else is different.
  void spread(const ConfigurationSpace& space, std::span<const Cell> starts, double limit, bool unknown = false,
              WayCost cost = WayCost::length, const Grid<std::uint8_t>* closed = nullptr,
              std::optional<Cell> until = std::nullopt);
  /// Nothing is reached any more: cells have moved.
  void clear();

  /// [m]; infinite where no way within the limit leads.
  double at(Cell cell) const {
    const int steps = steps_at(cell);
    return steps < 0 ? std::numeric_limits<double>::infinity() : steps * unit_;
  }
  /// The cells that are reached, in the order of their distance.
  const std::vector<Cell>& reached() const { return reached_; }

 private:
  int steps_at(Cell cell) const {
    const int x = cell.x - low_.x, y = cell.y - low_.y;
    return x < 0 || y < 0 || x >= width_ || y >= height_ ? -1 : steps_[index(x, y)];
  }
  int& steps(Cell cell) { return steps_[index(cell.x - low_.x, cell.y - low_.y)]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  void make_room(const ConfigurationSpace& space, std::span<const Cell> starts, int reach);

  Cell low_;
  int width_ = 0, height_ = 0;
  double unit_ = 1;
  std::vector<int> steps_;
  std::vector<std::vector<Cell>> buckets_;
  std::vector<Cell> reached_;
};

}  // namespace meander
