// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <array>
#include <cstddef>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "geometry/segment.hpp"
#include "geometry/shape_grid.hpp"

namespace meander {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One bit per lane of the outcome of a comparison.
template <class Mask>
unsigned bits(Mask mask) {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
#else
  return (mask[0] ? 1u : 0u) | (mask[1] ? 2u : 0u);
#endif
}

/// Limits [enter, leave] to where low <= origin + t * direction <= high.
void clip(double origin, double direction, double low, double high, double& enter, double& leave) {
  if (direction == 0) {
    if (origin < low || origin > high) leave = -kInfinity;
    return;
  }
  const double t0 = (low - origin) / direction, t1 = (high - origin) / direction;
  enter = std::max(enter, std::min(t0, t1));
  leave = std::min(leave, std::max(t0, t1));
}

}  // namespace

inline void ShapeGrid::cast_in_cell(const Cell& cell, NearestHit& nearest, const Vec2& origin,
                                    const Vec2& direction) const {
  const double ox = origin.x(), oy = origin.y(), ux = direction.x(), uy = direction.y();
  for (const WallPair *pair = pairs_.begin(cell.walls), *end = pairs_.end(cell.walls); pair != end; ++pair) {
    const Lanes ax = pair->ax - ox, ay = pair->ay - oy, bx = pair->bx - ox, by = pair->by - oy;
    const Lanes side_a = ux * ay - uy * ax, side_b = ux * by - uy * bx;
    for (unsigned hits = bits(side_a * side_b <= 0); hits != 0; hits &= hits - 1) {
      const int i = std::countr_zero(hits);
      nearest.meet_straddling({ax[i], ay[i]}, {bx[i], by[i]}, side_a[i], side_b[i], pair->tag[i].owner);
    }
  }
  for (const PoleCopy *pole = poles_.begin(cell.poles), *end = poles_.end(cell.poles); pole != end; ++pole)
    nearest.meet_pole(pole->disc, pole->owner);
}

void ShapeGrid::cast(NearestHit& nearest, const Vec2& origin, const Vec2& direction) const {
  // All pieces keep a cell away from the rim, so the ray may be cut there, and overshooting a little stays in the grid.
  double enter = 0, leave = nearest.range();
  const Vec2 margin(frame_.side, frame_.side), low = frame_.low + margin, high = frame_.high() - margin;
  for (int axis = 0; axis < 2; ++axis) clip(origin[axis], direction[axis], low[axis], high[axis], enter, leave);
  if (!(enter <= leave)) return;

  const Vec2 start = origin + enter * direction;
  const std::array<int, 2> at{frame_.nearest_column(start.x()), frame_.nearest_row(start.y())};
  std::array<double, 2> next{kInfinity, kInfinity},
      delta{kInfinity, kInfinity};  // where the ray crosses the next border
  std::array<std::ptrdiff_t, 2> stride{1, frame_.columns};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double d = direction[static_cast<int>(axis)];
    if (std::abs(d) < 1e-200) continue;
    const double border = frame_.low[static_cast<int>(axis)] + (at[axis] + (d > 0)) * frame_.side;
    next[axis] = (border - origin[static_cast<int>(axis)]) / d;
    delta[axis] = frame_.side / std::abs(d);
    if (d < 0) stride[axis] = -stride[axis];
  }
  for (const Cell* cell = &cells_[frame_.index(at[0], at[1])];;) {
    cast_in_cell(*cell, nearest, origin, direction);
    const std::size_t axis = next[1] < next[0];  // an index, because a branch here would be guessed wrong half the time
    if (next[axis] >= std::min(nearest.range(), leave)) return;
    cell += stride[axis];
    next[axis] += delta[axis];
  }
}

inline double ShapeGrid::squared_distance_in_cell(const Cell& cell, const Vec2& point, double best) const {
  for (const WallPair *pair = pairs_.begin(cell.walls), *end = pairs_.end(cell.walls); pair != end; ++pair) {
    const Lanes dx = pair->bx - pair->ax, dy = pair->by - pair->ay;
    const Lanes ex = point.x() - pair->ax, ey = point.y() - pair->ay;
    Lanes t = (ex * dx + ey * dy) / (dx * dx + dy * dy);
    t = t < 0 ? Lanes{0, 0} : t;
    t = t > 1 ? Lanes{1, 1} : t;
    const Lanes px = ex - t * dx, py = ey - t * dy;
    const Lanes squared = px * px + py * py;
    for (int i = 0; i < 2; ++i) best = squared[i] < best ? squared[i] : best;
  }
  for (const PoleCopy *pole = poles_.begin(cell.poles), *end = poles_.end(cell.poles); pole != end; ++pole) {
    const double off = (pole->disc.center - point).norm() - pole->disc.radius;
    best = std::min(best, off * off);
  }
  return best;
}

double ShapeGrid::distance(const Vec2& point, double most) const {
  const int column = frame_.nearest_column(point.x()), row = frame_.nearest_row(point.y());
  double best = squared_distance_in_cell(cells_[frame_.index(column, row)], point, most * most);
  const auto near = [&](double gap) { return gap <= 0 || gap * gap < best; };
  const auto scan = [&](int c, int r) { best = squared_distance_in_cell(cells_[frame_.index(c, r)], point, best); };
  // Square rings of cells around the point's own, each side of a ring while it may hold something nearer.
  for (int k = 1;; ++k) {
    const Vec2 inner_low = frame_.low + frame_.side * Vec2(column - k + 1, row - k + 1);
    const Vec2 inner_high = frame_.low + frame_.side * Vec2(column + k, row + k);
    const int left = std::max(column - k, 0), right = std::min(column + k, frame_.columns - 1);
    const int bottom = std::max(row - k + 1, 0), top = std::min(row + k - 1, frame_.rows - 1);
    const bool below = row - k >= 0 && near(point.y() - inner_low.y());
    const bool above = row + k < frame_.rows && near(inner_high.y() - point.y());
    const bool before = column - k >= 0 && near(point.x() - inner_low.x());
    const bool behind = column + k < frame_.columns && near(inner_high.x() - point.x());
    if (!below && !above && !before && !behind) return std::min(most, std::sqrt(best));
    for (int c = left; below && c <= right; ++c) scan(c, row - k);
    for (int c = left; above && c <= right; ++c) scan(c, row + k);
    for (int r = bottom; before && r <= top; ++r) scan(column - k, r);
    for (int r = bottom; behind && r <= top; ++r) scan(column + k, r);
  }
}

bool ShapeGrid::touches_solid(const Cell& cell, const Vec2& point) const {
  for (const PoleCopy *pole = poles_.begin(cell.poles), *end = poles_.end(cell.poles); pole != end; ++pole)
    if ((point - pole->disc.center).norm() <= pole->disc.radius + kTouch) return true;
  for (const WallPair *pair = pairs_.begin(cell.walls), *end = pairs_.end(cell.walls); pair != end; ++pair)
    for (int i = 0; i < 2; ++i)
      if (pair->tag[i].id != kNoWall && pair->tag[i].solid &&
          squared_distance_to_segment(point, {pair->ax[i], pair->ay[i]}, {pair->bx[i], pair->by[i]}) <= kTouch * kTouch)
        return true;
  return false;
}

bool ShapeGrid::inside(const Vec2& point) const {
  if (!Box{frame_.low, frame_.high() - Vec2(frame_.side, frame_.side)}.contains(point)) return false;
  const int first = frame_.column(point.x()), row = frame_.row(point.y());
  if (touches_solid(cells_[frame_.index(first, row)], point)) return true;
  // Towards +x until a cell without walls, whose depth is true of all its points, counting the crossings on the way. A
  // crossing counts in the cell that it lies in.
  int depth = 0;
  for (int column = first; column < frame_.columns; ++column) {
    const Cell& cell = cells_[frame_.index(column, row)];
    if (cell.walls.count == 0) return depth + depth_[frame_.index(column, row)] > 0;
    for (const WallPair *pair = pairs_.begin(cell.walls), *end = pairs_.end(cell.walls); pair != end; ++pair)
      for (int i = 0; i < 2; ++i) {
        const Vec2 a(pair->ax[i], pair->ay[i]), b(pair->bx[i], pair->by[i]);
        const int step = pair->tag[i].solid ? winding_step(point, a, b) : 0;
        if (step == 0) continue;
        const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (std::max(first, frame_.column(x)) == column) depth += step;
      }
  }
  return depth > 0;
}

}  // namespace meander
