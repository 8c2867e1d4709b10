// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "geometry/shape_grid.hpp"

#include <cassert>
#include <limits>

namespace meander {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

ShapeGrid::ShapeGrid(const CellFrame& frame) : frame_(frame), cells_(frame.size()), depth_(frame.size()) {}

void ShapeGrid::push(Cell& cell, const Wall& wall, std::uint32_t id) {
  WallPair* last = pairs_.end(cell.walls) - 1;
  if (cell.walls.count == 0 || last->tag[1].id != kNoWall) {
    pairs_.push(cell.walls, WallPair{{kNan, kNan}, {kNan, kNan}, {kNan, kNan}, {kNan, kNan}, {}});
    last = pairs_.end(cell.walls) - 1;
  }
  const int lane = last->tag[0].id == kNoWall ? 0 : 1;
  last->ax[lane] = wall.a.x(), last->ay[lane] = wall.a.y();
  last->bx[lane] = wall.b.x(), last->by[lane] = wall.b.y();
  last->tag[lane] = {id, wall.owner, wall.solid};
}

void ShapeGrid::erase(Cell& cell, std::uint32_t id) {
  WallPair* pair = pairs_.begin(cell.walls);
  while (pair->tag[0].id != id && pair->tag[1].id != id) ++pair;
  const int lane = pair->tag[0].id == id ? 0 : 1;
  WallPair* last = pairs_.end(cell.walls) - 1;
  const int last_lane = last->tag[1].id == kNoWall ? 0 : 1;
  pair->ax[lane] = last->ax[last_lane], pair->ay[lane] = last->ay[last_lane];
  pair->bx[lane] = last->bx[last_lane], pair->by[lane] = last->by[last_lane];
  pair->tag[lane] = last->tag[last_lane];
  last->ax[last_lane] = last->ay[last_lane] = last->bx[last_lane] = last->by[last_lane] = kNan;
  last->tag[last_lane] = {};
  if (last_lane == 0) pairs_.resize(cell.walls, cell.walls.count - 1);
}

void ShapeGrid::add(const Wall& wall, std::uint32_t id) {
  for_each_cell(frame_, wall.a, wall.b, [&](std::size_t cell) { push(cells_[cell], wall, id); });
}

void ShapeGrid::remove(const Wall& wall, std::uint32_t id) {
  for_each_cell(frame_, wall.a, wall.b, [&](std::size_t cell) { erase(cells_[cell], id); });
}

void ShapeGrid::add(const Pole& pole) {
  for_each_cell(frame_, pole.disc, [&](std::size_t cell) { poles_.push(cells_[cell].poles, {pole.disc, pole.owner}); });
}

void ShapeGrid::remove(const Pole& pole) {
  for_each_cell(frame_, pole.disc, [&](std::size_t cell) {
    PoleCopy* copy = poles_.begin(cells_[cell].poles);
    while (copy->owner != pole.owner) ++copy;
    poles_.erase(cells_[cell].poles, copy);
  });
}

void ShapeGrid::cover(std::span<const Wall> walls, const Box& box, int sign) {
  const int left = frame_.column(box.low.x()), bottom = frame_.row(box.low.y());
  const int width = frame_.column(box.high.x()) - left + 2, height = frame_.row(box.high.y()) - bottom + 1;
  // steps_: how the depth changes from one centre of a row to the next; a wall ends the solid at the first centre
  // beyond it.
  steps_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  for (const Wall& w : walls) {
    const bool upwards = w.a.y() <= w.b.y();
    const Vec2 &low = upwards ? w.a : w.b, &high = upwards ? w.b : w.a;
    const auto center_above = [&](double y) {
      return static_cast<int>(std::ceil((y - frame_.low.y()) / frame_.side - 0.5));
    };
    for (int row = center_above(low.y()); row < center_above(high.y()); ++row) {
      const double y = frame_.center(0, row).y();
      const double x = low.x() + (y - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
      const int beyond = static_cast<int>(std::ceil((x - frame_.low.x()) / frame_.side - 0.5)) - left;
      const auto line = static_cast<std::size_t>(row - bottom) * static_cast<std::size_t>(width);
      steps_[line + static_cast<std::size_t>(std::clamp(beyond, 0, width - 1))] += upwards ? -sign : sign;
    }
  }
  for (int row = 0; row < height; ++row) {
    std::int32_t depth = 0;
    for (int column = 0; column < width - 1; ++column) {
      depth +=
          steps_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
      depth_[frame_.index(left + column, bottom + row)] += depth;
    }
  }
}

}  // namespace meander
