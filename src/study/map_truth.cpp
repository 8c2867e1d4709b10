// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/map_truth.hpp"

#include <algorithm>

#include "world/rasterize.hpp"

namespace meander {
namespace {

constexpr double kMostScored = 1e6;  ///< cells

/// How far one sees from the robot towards a point, at most to the point.
double sight(const Scene& scene, const Vec2& from, const Vec2& way, double distance) {
  const auto hit = scene.walls().cast(from, way / distance, distance);
  return hit ? hit->range : distance;
}

}  // namespace

Grid<CellTruth> map_truth(const Sim& sim, std::size_t robot, int width, int height, const GridFrame& frame,
                          const MapTruthOptions& options) {
  validate(options);
  if (frame.origin.heading != 0) fail("grid: one along the axes of the world expected");
  if (static_cast<double>(width) * height > kMostScored)
    fail("grid: at most {} cells expected, got {} x {}", kMostScored, width, height);
  Grid<CellTruth> truth(width, height, CellTruth::hidden, frame);
  if (width == 0 || height == 0) return truth;
  const Vec2 low = frame.origin.position(), robot_at = sim.state(robot).pose_world.position();
  // Half a cell less, lest rounding adds a row or a column.
  const Vec2 size = frame.resolution * Vec2(width - 0.5, height - 0.5);
  const Grid<std::uint8_t> solid = rasterize(sim.world(), frame.resolution, {low, low + size});
  const Box& bounds = sim.world().header().bounds;
  const double body = sim.robot(robot).platform.body.radius;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec2 center = frame.center({x, y}), way = center - robot_at;
      const double distance = way.norm();
      if (!bounds.contains(center) || distance <= body) continue;
      if (sight(sim.scene(), robot_at, way, distance) + options.slack < distance) continue;
      truth[{x, y}] = solid.at({x, y}, 0) ? CellTruth::occupied : CellTruth::free;
    }
  return truth;
}

}  // namespace meander
