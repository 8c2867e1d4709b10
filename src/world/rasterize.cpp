// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/rasterize.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// How deep something must reach into a cell to count [cells]: above the rounding of coordinates.
constexpr double kDepth = 1e-6;

/// Draws into a grid, in coordinates of cells.
class Raster {
 public:
  explicit Raster(Grid<std::uint8_t>& grid) : grid_(grid) {}

  void draw(const Shape& shape) {
    if (const auto* disc = std::get_if<Disc>(&shape)) return draw(*disc);
    // A thin wall has no depth: it takes the cells that it touches.
    const double depth = std::holds_alternative<Chain>(shape) ? -kDepth : kDepth;
    std::vector<Edge> edges;
    for (const Ring& ring : rings(shape)) {
      for (std::size_t i = 0; i + (ring.closed ? 0 : 1) < ring.points.size(); ++i)
        edges.push_back({in_cells(ring.points[i]), in_cells(ring.points[(i + 1) % ring.points.size()])});
    }
    for (const Edge& edge : edges) mark_touched(edge, depth);
    if (!std::holds_alternative<Chain>(shape)) fill(edges);
  }

 private:
  struct Edge {
    Vec2 a, b;
  };

  Vec2 in_cells(const Vec2& point) const { return inverse(grid_.frame.origin) * point / grid_.frame.resolution; }

  void draw(const Disc& disc) {
    const Vec2 center = in_cells(disc.center);
    const double radius = disc.radius / grid_.frame.resolution - kDepth;
    for (int y = row(center.y() - radius); y <= row(center.y() + radius); ++y) {
      const double dy = center.y() - std::clamp(center.y(), double(y), y + 1.0);
      if (std::abs(dy) >= radius) continue;
      const double half = std::sqrt(radius * radius - dy * dy);
      mark(y, std::floor(center.x() - half), std::ceil(center.x() + half) - 1);
    }
  }

  /// The cells whose inside, made smaller by `depth` on each side, the edge meets.
  void mark_touched(const Edge& edge, double depth) {
    const Vec2 &low = edge.a.y() <= edge.b.y() ? edge.a : edge.b, &high = edge.a.y() <= edge.b.y() ? edge.b : edge.a;
    for (int y = row(low.y() - 1); y <= row(high.y() + 1); ++y) {
      const double from = std::max(low.y(), y + depth), to = std::min(high.y(), y + 1 - depth);
      if (from > to) continue;
      const Vec2 along = high - low;
      double x0 = low.x(), x1 = high.x();
      if (along.y() > 0) {
        x1 = x0 + along.x() * ((to - low.y()) / along.y());
        x0 += along.x() * ((from - low.y()) / along.y());
      }
      if (x0 > x1) std::swap(x0, x1);
      mark(y, std::ceil(x0 - 1 + depth), std::floor(x1 - depth));
    }
  }

  /// The cells whose centres lie inside, by the parity of crossings along each row of centres.
  void fill(const std::vector<Edge>& edges) {
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(grid_.height()));
    for (const auto& [a, b] : edges) {
      const Vec2 &low = a.y() <= b.y() ? a : b, &high = a.y() <= b.y() ? b : a;
      for (int y = row(low.y() - 1); y <= row(high.y()); ++y) {
        const double at = y + 0.5;
        if (low.y() <= at && at < high.y())
          crossings[static_cast<std::size_t>(y)].push_back(low.x() + (high.x() - low.x()) * (at - low.y()) /
                                                                         (high.y() - low.y()));
      }
    }
    for (int y = 0; y < grid_.height(); ++y) {
      auto& xs = crossings[static_cast<std::size_t>(y)];
      std::sort(xs.begin(), xs.end());
      for (std::size_t i = 0; i + 1 < xs.size(); i += 2)
        mark(y, std::ceil(xs[i] - 0.5), std::ceil(xs[i + 1] - 0.5) - 1);
    }
  }

  int row(double y) const { return static_cast<int>(std::clamp(std::floor(y), 0.0, grid_.height() - 1.0)); }

  void mark(int y, double first, double last) {
    const double low = std::max(first, 0.0), high = std::min(last, grid_.width() - 1.0);
    for (double x = low; x <= high; ++x) grid_[{static_cast<int>(x), y}] = 1;
  }

  Grid<std::uint8_t>& grid_;
};

}  // namespace

Grid<std::uint8_t> rasterize(const World& world, double resolution, const Box& box, const Work& work) {
  if (!(resolution > 0) || !std::isfinite(resolution))
    fail("rasterize: resolution > 0 [m] expected, got {}", resolution);
  if (!box.low.allFinite() || !box.high.allFinite()) fail("rasterize: a box of finite numbers expected");
  // A box of whole cells stays one although neither its size nor the resolution is a round binary number.
  const auto count = [&](double size) { return std::max(1.0, std::ceil(size / resolution - kDepth)); };
  const double width = count(box.size().x()), height = count(box.size().y());
  if (!(width * height <= kMaxCells))
    fail("rasterize: {} x {} cells of {} m, at most {} are made", width, height, resolution, kMaxCells);
  Grid<std::uint8_t> grid(static_cast<int>(width), static_cast<int>(height), 0,
                          {resolution, {box.low.x(), box.low.y(), 0}});
  Raster raster(grid);
  for (const Id id : world.ids()) {
    work.poll();
    if (const Shape* shape = blocking_shape(world.item(id))) raster.draw(*shape);
  }
  return grid;
}

Grid<std::uint8_t> rasterize(const World& world, double resolution) {
  return rasterize(world, resolution, world.header().bounds);
}

}  // namespace meander
