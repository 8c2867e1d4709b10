// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_grid.hpp"

#include <limits>

namespace meander {
ShapeGrid::ShapeGrid(const CellFrame& frame)
    : frame_(frame), cells_(frame.size()), occupied_(frame.size()), depth_(frame.size()) {}

void ShapeGrid::push(std::size_t index, const Vec2& a, const Vec2& b, std::uint32_t id) {
  Cell& cell = cells_[index];
  occupied_.insert(index);
  if (cell.walls.count == 0 || (blocks_.end(cell.walls) - 1)->id[kLanes - 1] != kNoWall) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr Lanes kUnused{kNan, kNan, kNan, kNan};
    blocks_.push(cell.walls, {kUnused, kUnused, kUnused, kUnused, {kNoWall, kNoWall, kNoWall, kNoWall}});
  }
  WallBlock* last = blocks_.end(cell.walls) - 1;
  int lane = 0;
  while (last->id[lane] != kNoWall) ++lane;
  last->ax[lane] = static_cast<float>(a.x()), last->ay[lane] = static_cast<float>(a.y());
  last->bx[lane] = static_cast<float>(b.x()), last->by[lane] = static_cast<float>(b.y());
  last->id[lane] = id;
}

void ShapeGrid::erase(std::size_t index, std::uint32_t id) {
  Cell& cell = cells_[index];
  WallBlock *block = blocks_.begin(cell.walls), *last = blocks_.end(cell.walls) - 1;
  int lane = 0, last_lane = kLanes - 1;
  while (block->id[lane] != id)
    if (++lane == kLanes) lane = 0, ++block;
  while (last->id[last_lane] == kNoWall) --last_lane;
  for (const auto member : {&WallBlock::ax, &WallBlock::ay, &WallBlock::bx, &WallBlock::by}) {
    (block->*member)[lane] = (last->*member)[last_lane];
    (last->*member)[last_lane] = std::numeric_limits<float>::quiet_NaN();
  }
  block->id[lane] = last->id[last_lane];
  last->id[last_lane] = kNoWall;
  if (last_lane == 0) blocks_.resize(cell.walls, cell.walls.count - 1);
  if (empty(cell)) occupied_.erase(index);
}

void ShapeGrid::add(const Wall& wall, std::uint32_t id) {
  const Vec2 d = wall.b - wall.a;
  for_each_cell(frame_, wall.a, wall.b, [&](int column, int row, double t0, double t1) {
    const Vec2 a = wall.a - (frame_.low + frame_.side * Vec2(column, row));
    push(frame_.index(column, row), a + t0 * d, a + t1 * d, id);
  });
}

void ShapeGrid::remove(const Wall& wall, std::uint32_t id) {
  for_each_cell(frame_, wall.a, wall.b,
                [&](int column, int row, double, double) { erase(frame_.index(column, row), id); });
}

void ShapeGrid::add(const Pole& pole) {
  for_each_cell(frame_, pole.disc, [&](std::size_t index) {
    occupied_.insert(index);
    poles_.push(cells_[index].poles, {pole.disc, pole.owner});
  });
}

void ShapeGrid::remove(const Pole& pole) {
  for_each_cell(frame_, pole.disc, [&](std::size_t index) {
    Cell& cell = cells_[index];
    PoleCopy* copy = poles_.begin(cell.poles);
    while (copy->owner != pole.owner) ++copy;
    poles_.erase(cell.poles, copy);
    if (empty(cell)) occupied_.erase(index);
  });
}

void ShapeGrid::cover(std::span<const Wall> walls, const Box& box, int sign) {
  const int left = frame_.column(box.low.x()), bottom = frame_.row(box.low.y());
  const int width = frame_.column(box.high.x()) - left + 2, height = frame_.row(box.high.y()) - bottom + 1;
  const auto at = [&](int column, int row) {
    return static_cast<std::size_t>(row - bottom) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column - left);
  };
  const double half = 0.5 * frame_.side;  // column(x + half) is the first whose centres lie beyond x
  // How the depth changes from one centre of a row to the next: where a wall lies between them.
  steps_.assign(at(left, bottom + height), 0);
  for (const Wall& w : walls) {
    const bool upwards = w.a.y() <= w.b.y();
    const Vec2 &low = upwards ? w.a : w.b, &high = upwards ? w.b : w.a;
    const int end = frame_.row(high.y() + half);
    for (int row = frame_.row(low.y() + half); row < end; ++row) {
      const double y = frame_.low.y() + row * frame_.side + half;
      const double x = low.x() + (y - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
      steps_[at(std::clamp(frame_.column(x + half), left, left + width - 1), row)] += upwards ? -sign : sign;
    }
  }
  for (int row = bottom; row < bottom + height; ++row) {
    std::int32_t depth = 0;
    for (int column = left; column < left + width - 1; ++column) {
      depth += steps_[at(column, row)];
      depth_[frame_.index(column, row)] += depth;
    }
  }
}

}  // namespace meander
