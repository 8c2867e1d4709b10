// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <bit>
#include <cstddef>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "geometry/segment.hpp"
#include "geometry/shape_grid.hpp"

namespace meander {
namespace {

/// One bit per lane of the outcome of a comparison.
template <class Mask>
unsigned bits(Mask mask) {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
  return (mask[0] ? 1u : 0u) | (mask[1] ? 2u : 0u) | (mask[2] ? 4u : 0u) | (mask[3] ? 8u : 0u);
#endif
}

/// 1 / x, but finite: a ray that never crosses any border of an axis crosses it at a very large range.
double finite_reciprocal(double x) { return std::abs(x) < 1e-200 ? std::copysign(1e200, x) : 1 / x; }

}  // namespace

ShapeGrid::Lanes ShapeGrid::lanes(double x) { return Lanes{} + static_cast<float>(x); }

NearestHit ShapeGrid::cast(NearestHit nearest, const Wall* walls, const Vec2& origin, const Vec2& direction) const {
  const Vec2 per_metre(finite_reciprocal(direction.x()), finite_reciprocal(direction.y()));
  // All pieces keep a cell away from the rim, so the ray may be cut there, and overshooting a little stays in the grid.
  const Vec2 margin(frame_.side, frame_.side);
  const Vec2 t_low = (frame_.low + margin - origin).cwiseProduct(per_metre);
  const Vec2 t_high = (frame_.high() - margin - origin).cwiseProduct(per_metre);
  const double enter = std::max(0.0, t_low.cwiseMin(t_high).maxCoeff());
  const double leave = t_low.cwiseMax(t_high).minCoeff();
  if (!(enter <= std::min(leave, nearest.range()))) return nearest;

  const Vec2 start = origin + enter * direction;
  const int column = frame_.nearest_column(start.x()), row = frame_.nearest_row(start.y());
  const Vec2 corner = frame_.low + frame_.side * Vec2(column, row);
  const bool right = per_metre.x() > 0, up = per_metre.y() > 0;
  const Vec2 border = corner + frame_.side * Vec2(right, up);
  // Where the ray crosses the next border of either axis. What a step does is looked up by its axis, because a branch
  // would be guessed wrong half the time.
  double next_x = (border.x() - origin.x()) * per_metre.x(), next_y = (border.y() - origin.y()) * per_metre.y();
  const double later_x[2] = {frame_.side * std::abs(per_metre.x()), 0};
  const double later_y[2] = {0, frame_.side * std::abs(per_metre.y())};
  const std::ptrdiff_t stride[2] = {right ? 1 : -1, up ? frame_.columns : -frame_.columns};
  // The ray's line in a cell is ux * y - uy * x = offset, from the cell's corner.
  double offset = cross(direction, origin - corner);
  const double shift[2] = {right ? frame_.side * direction.y() : -frame_.side * direction.y(),
                           up ? -frame_.side * direction.x() : frame_.side * direction.x()};
  const Lanes ux = lanes(direction.x()), uy = lanes(direction.y());
  // Both ends' distances from the line are within a cell's diagonal and rounded by less than 1e-6 of it.
  const Lanes slack = lanes(4e-6 * frame_.side * frame_.side);
  for (const Cell* cell = &cell_at(column, row);;) {
    const Lanes c = lanes(offset);
    for (const WallBlock& block : blocks_.items(cell->walls)) {
      const Lanes side_a = ux * block.ay - uy * block.ax - c, side_b = ux * block.by - uy * block.bx - c;
      for (unsigned hits = bits(side_a * side_b <= slack); hits != 0; hits &= hits - 1) {
        const Wall& wall = walls[block.id[std::countr_zero(hits)]];
        nearest.meet_wall(wall.a - origin, wall.b - origin, wall.owner);
      }
    }
    for (const PoleCopy& pole : poles_.items(cell->poles)) nearest.meet_pole(pole.disc, pole.owner);
    if (std::min(next_x, next_y) >= std::min(nearest.range(), leave)) return nearest;
    const bool axis = next_y < next_x;
    cell += stride[axis];
    offset += shift[axis];
    next_x += later_x[axis];
    next_y += later_y[axis];
  }
}

double ShapeGrid::squared_distance(const Cell& cell, const Wall* walls, const Vec2& point, double best) const {
  for_each_wall(cell, [&](std::uint32_t id) {
    best = std::min(best, squared_distance_to_segment(point, walls[id].a, walls[id].b));
  });
  for (const PoleCopy& pole : poles_.items(cell.poles)) {
    const double off = (pole.disc.center - point).norm() - pole.disc.radius;
    best = std::min(best, off * off);
  }
  return best;
}

double ShapeGrid::distance(const Wall* walls, const Vec2& point, double most) const {
  const int column = frame_.nearest_column(point.x()), row = frame_.nearest_row(point.y());
  double best = most * most;
  // Outwards from the point's own column, in rows outwards from its own row, while a cell may hold something nearer.
  const auto visit_row = [&](int r, double gap_y) {
    const double reach = std::sqrt(best - gap_y * gap_y);
    const auto visit = [&](std::size_t index, double gap_x) {
      if (gap_x > 0 && gap_x * gap_x + gap_y * gap_y >= best) return false;
      best = squared_distance(cells_[index], walls, point, best);
      return true;
    };
    const std::size_t start = frame_.index(0, r), middle = frame_.index(column, r);
    const std::size_t left = frame_.index(frame_.nearest_column(point.x() - reach), r);
    const std::size_t end = frame_.index(frame_.nearest_column(point.x() + reach), r) + 1;
    const auto border = [&](std::size_t index) {
      return frame_.low.x() + static_cast<double>(index - start) * frame_.side;
    };
    for (std::size_t i = occupied_.next(middle, end); i < end; i = occupied_.next(i + 1, end))
      if (!visit(i, border(i) - point.x())) break;
    for (std::size_t i = occupied_.last(left, middle); i > left; i = occupied_.last(left, i - 1))
      if (!visit(i - 1, point.x() - border(i))) break;
  };
  visit_row(row, 0);
  for (int k = 1;; ++k) {
    const double below = std::max(0.0, point.y() - (frame_.low.y() + (row - k + 1) * frame_.side));
    const double above = std::max(0.0, frame_.low.y() + (row + k) * frame_.side - point.y());
    const bool down = row - k >= 0 && below * below < best, up = row + k < frame_.rows && above * above < best;
    if (!down && !up) return std::min(most, std::sqrt(best));
    if (down) visit_row(row - k, below);
    if (up && above * above < best) visit_row(row + k, above);
  }
}

bool ShapeGrid::touches_solid(const Cell& cell, const Wall* walls, const Vec2& point) const {
  for (const PoleCopy& pole : poles_.items(cell.poles))
    if ((point - pole.disc.center).norm() <= pole.disc.radius + kTouch) return true;
  bool touches = false;
  for_each_wall(cell, [&](std::uint32_t id) {
    const Wall& w = walls[id];
    touches |= w.solid && squared_distance_to_segment(point, w.a, w.b) <= kTouch * kTouch;
  });
  return touches;
}

bool ShapeGrid::inside(const Wall* walls, const Vec2& point) const {
  if (!Box{frame_.low, frame_.high() - Vec2(frame_.side, frame_.side)}.contains(point)) return false;
  const int first = frame_.column(point.x()), row = frame_.row(point.y());
  if (touches_solid(cell_at(first, row), walls, point)) return true;
  // Towards +x until a cell without solid walls, whose depth is true of all its points, counting the crossings on the
  // way. A crossing counts in the cell that it lies in.
  int depth = 0;
  for (int column = first; column < frame_.columns; ++column) {
    bool bordered = false;
    for_each_wall(cell_at(column, row), [&](std::uint32_t id) {
      const Wall& w = walls[id];
      bordered |= w.solid;
      const int step = w.solid ? winding_step(point, w.a, w.b) : 0;
      if (step == 0) return;
      const double x = w.a.x() + (point.y() - w.a.y()) / (w.b.y() - w.a.y()) * (w.b.x() - w.a.x());
      if (std::max(first, frame_.column(x)) == column) depth += step;
    });
    if (!bordered) return depth + depth_[frame_.index(column, row)] > 0;
  }
  return depth > 0;
}

}  // namespace meander
