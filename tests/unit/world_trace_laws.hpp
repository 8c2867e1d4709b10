// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What holds for every traced raster, checked without the code under test.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "world/rasterize.hpp"
#include "world/trace.hpp"

namespace meander {

using Raster = Grid<std::uint8_t>;

/// Cells whose centres lie in one of the polygons: parity of crossings, written without the code under test.
inline Raster centers_inside(const std::vector<Polygon>& solids, const Raster& like) {
  Raster grid(like.width(), like.height());
  for (int y = 0; y < grid.height(); ++y) {
    std::vector<double> xs;
    const double at = y + 0.5;
    const auto cross_ring = [&](const std::vector<Vec2>& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        if ((a.y() <= at) != (b.y() <= at)) xs.push_back(a.x() + (b.x() - a.x()) * (at - a.y()) / (b.y() - a.y()));
      }
    };
    for (const Polygon& solid : solids) {
      cross_ring(solid.outer);
      for (const auto& hole : solid.holes) cross_ring(hole);
    }
    std::sort(xs.begin(), xs.end());
    for (int x = 0; x < grid.width(); ++x)
      grid[{x, y}] = (std::upper_bound(xs.begin(), xs.end(), x + 0.5) - xs.begin()) % 2;
  }
  return grid;
}

/// The areas of cells of one value that hang together, also across corners or not, numbered from 1; 0 elsewhere.
inline Grid<int> labelled(const Raster& grid, std::uint8_t value, bool across_corners, int* count = nullptr) {
  Grid<int> labels(grid.width(), grid.height());
  int last = 0;
  std::vector<Cell> todo;
  const auto take = [&](Cell cell) {
    if (grid.at(cell, !value) != value || labels.at(cell, 1)) return;
    labels[cell] = last;
    todo.push_back(cell);
  };
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) {
      if (grid[{x, y}] != value || labels[{x, y}]) continue;
      ++last;
      for (take({x, y}); !todo.empty();) {
        const Cell c = todo.back();
        todo.pop_back();
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            if (across_corners || !dx || !dy) take({c.x + dx, c.y + dy});
      }
    }
  if (count) *count = last;
  return labels;
}

inline int areas(const Raster& grid, std::uint8_t value, bool across_corners) {
  int count = 0;
  labelled(grid, value, across_corners, &count);
  return count;
}

inline Raster with_free_rim(const Raster& grid) {
  Raster wider(grid.width() + 2, grid.height() + 2);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) wider[{x + 1, y + 1}] = grid[{x, y}];
  return wider;
}

/// How far ring points stray from the sides of cells between solid and free.
inline double farthest_stray(const std::vector<Polygon>& solids, const Raster& grid) {
  const auto distance_to_sides = [&](const Vec2& p) {
    double best = 1e9;
    const int cx = static_cast<int>(std::floor(p.x())), cy = static_cast<int>(std::floor(p.y()));
    for (int y = cy - 2; y <= cy + 2; ++y)
      for (int x = cx - 2; x <= cx + 2; ++x) {
        const auto here = grid.at({x, y}, 0);
        if (here != grid.at({x + 1, y}, 0)) best = std::min(best, distance_to_segment(p, {x + 1, y}, {x + 1, y + 1}));
        if (here != grid.at({x, y + 1}, 0)) best = std::min(best, distance_to_segment(p, {x, y + 1}, {x + 1, y + 1}));
      }
    return best;
  };
  double worst = 0;
  const auto along = [&](const std::vector<Vec2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (double t = 0; t < 1; t += 0.25)
        worst = std::max(worst, distance_to_sides(ring[i] + t * (ring[(i + 1) % ring.size()] - ring[i])));
  };
  for (const Polygon& solid : solids) {
    along(solid.outer);
    for (const auto& hole : solid.holes) along(hole);
  }
  return worst;
}

/// Everything that trace() promises for any raster.
inline void expect_faithful(const Raster& grid, const TraceOptions& options, const std::string& what) {
  const Traced traced = trace(grid, options);
  std::size_t holes = 0;
  for (const Polygon& solid : traced.solids) {
    const auto complaint = invalid(Shape(solid));
    ASSERT_FALSE(complaint) << what << ": " << *complaint;
    ASSERT_EQ(canonical(Shape(solid)), Shape(solid)) << what;
    holes += solid.holes.size();
  }
  ASSERT_EQ(centers_inside(traced.solids, grid), grid) << what;
  ASSERT_EQ(static_cast<int>(traced.solids.size()), areas(grid, 1, true)) << what;
  // Free areas: the holes and what lies around everything.
  ASSERT_EQ(static_cast<int>(holes) + 1, areas(with_free_rim(grid), 0, false)) << what;
  ASSERT_EQ(traced.holes, holes) << what;
  ASSERT_LE(farthest_stray(traced.solids, grid), 1) << what;
}

inline World world_of(const std::vector<Polygon>& solids, const Raster& grid) {
  Header header;
  header.bounds = {{0, 0}, Vec2(grid.width(), grid.height())};
  World world(header);
  for (const Polygon& solid : solids) world.add(Obstacle{"", solid, {}});
  return world;
}

/// Draws the traced solids with cells a fifth as large and floods: no way leads from one free area of the raster into
/// another one. What lies beyond the rim is one free area.
inline void expect_no_leak(const Raster& raster, const TraceOptions& options, const std::string& what) {
  constexpr int kFine = 5;
  const Raster grid = with_free_rim(raster);
  const World world = world_of(trace(grid, options).solids, grid);
  const Raster fine = rasterize(world, 1.0 / kFine);
  ASSERT_EQ(fine.width(), kFine * grid.width());
  int count = 0;
  const Grid<int> ways = labelled(fine, 0, false, &count), before = labelled(grid, 0, false);
  std::vector<int> area_of(static_cast<std::size_t>(count) + 1, 0);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) {
      const Cell center{kFine * x + kFine / 2, kFine * y + kFine / 2};
      ASSERT_GE(fine[center], (grid[{x, y}])) << what;
      if (!ways[center]) continue;
      int& area = area_of[static_cast<std::size_t>(ways[center])];
      if (area == 0) area = before[{x, y}];
      ASSERT_EQ(area, (before[{x, y}])) << what << ": a leak near cell " << x - 1 << ", " << y - 1;
    }
}

}  // namespace meander
