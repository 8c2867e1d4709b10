// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/planning_map.hpp"

#include <algorithm>
#include <cmath>

#include "planning/clearance.hpp"

namespace meander {
namespace {

/// Calls visit(cell) for the cells whose centres lie in the box [m]. Of a map that lies askew, too: its corners tell
/// which cells to look at.
template <class Visit>
void cells_in(const Grid<std::uint8_t>& grid, const Box& box, Visit visit) {
  Cell first{grid.width(), grid.height()}, last{-1, -1};
  for (const Vec2& corner : {box.low, box.high, Vec2(box.low.x(), box.high.y()), Vec2(box.high.x(), box.low.y())}) {
    const Cell cell = grid.frame.cell(corner);
    first = {std::min(first.x, cell.x), std::min(first.y, cell.y)};
    last = {std::max(last.x, cell.x), std::max(last.y, cell.y)};
  }
  for (int y = std::max(first.y, 0); y <= std::min(last.y, grid.height() - 1); ++y)
    for (int x = std::max(first.x, 0); x <= std::min(last.x, grid.width() - 1); ++x)
      if (box.contains(grid.frame.center({x, y}))) visit(Cell{x, y});
}

template <class T>
void give_all(Grid<T>& grid, const Grid<std::uint8_t>& like, const T& value) {
  if (grid.cells().empty()) grid = Grid<T>(like.width(), like.height(), value, like.frame);
}

PlanningProblem on_squares(const PlanningMap& map, const PlanningTask& task, double radius, const Work& work) {
  PlanningProblem problem{.blocked = blocked_for(map.solid, radius, work), .targets = {}};
  problem.difficulty = map.difficulty;
  problem.drag = map.drag;
  problem.corners = task.corners;
  if (radius > 0) problem.obstacles = map.solid;
  return problem;
}

PlanningProblem on_hexagons(const PlanningMap& map, double radius, const Work& work) {
  const Grid<std::uint8_t>& solid = map.solid;
  const double pitch = std::sqrt(3.0) / 2;  // between rows [cells]
  const int width = std::max(solid.width() - 1, 1), height = std::max(static_cast<int>(solid.height() / pitch), 1);
  PlanningProblem problem{.blocked = Grid<std::uint8_t>(width, height, 0, solid.frame), .targets = {}};
  problem.lattice = Lattice::hexagonal;
  problem.obstacles = solid;
  if (!map.difficulty.cells().empty()) give_all(problem.difficulty, problem.blocked, 1.0F);
  if (!map.drag.cells().empty()) give_all(problem.drag, problem.blocked, Eigen::Vector2f(0, 0));
  const Clearance clearance(solid);
  const double reach = std::sqrt(radius * radius + 0.25);  // half a step beside it, still the radius
  for (int y = 0; y < height; ++y) {
    work.poll();
    for (int x = 0; x < width; ++x) {
      const Vec2 center = cell_center(Lattice::hexagonal, {x, y});
      const Cell square{std::min(static_cast<int>(center.x()), solid.width() - 1),
                        std::min(static_cast<int>(center.y()), solid.height() - 1)};
      problem.blocked[{x, y}] = clearance.of(center, center, reach) < reach - 1e-9;
      if (!problem.difficulty.cells().empty()) problem.difficulty[{x, y}] = map.difficulty[square];
      if (!problem.drag.cells().empty()) problem.drag[{x, y}] = map.drag[square];
    }
  }
  return problem;
}

}  // namespace

PlanningMap map_from_occupancy(const Grid<float>& probability, const OccupancyOptions& options) {
  validate(options);
  if (options.vacant > options.occupied)
    fail("option 'vacant': at most {} expected, as 'occupied' is, got {}", options.occupied, options.vacant);
  PlanningMap map{.solid = Grid<std::uint8_t>(probability.width(), probability.height(), 0, probability.frame)};
  if (options.unknown == UnknownCells::costly) give_all(map.difficulty, map.solid, 1.0F);
  for (std::size_t i = 0; i < probability.cells().size(); ++i) {
    const auto p = static_cast<double>(probability.cells()[i]);
    if (p >= options.occupied && p <= 1) {
      map.solid.cells()[i] = 1;
    } else if (!(p <= options.vacant && p >= 0)) {
      if (options.unknown == UnknownCells::blocked) map.solid.cells()[i] = 1;
      if (options.unknown == UnknownCells::costly) map.difficulty.cells()[i] = static_cast<float>(options.unknown_cost);
    }
  }
  return map;
}

void set_solid(PlanningMap& map, const Box& box, bool solid) {
  cells_in(map.solid, box, [&](Cell cell) { map.solid[cell] = solid ? 1 : 0; });
  ++map.version;
}

void set_difficulty(PlanningMap& map, const Box& box, double difficulty) {
  if (!(difficulty >= kLeastDifficulty && difficulty <= kMostDifficulty))
    fail("difficulty: a number from {} to {} expected, got {}", kLeastDifficulty, kMostDifficulty, difficulty);
  give_all(map.difficulty, map.solid, 1.0F);
  cells_in(map.solid, box, [&](Cell cell) { map.difficulty[cell] = static_cast<float>(difficulty); });
  ++map.version;
}

void set_drag(PlanningMap& map, const Box& box, const Vec2& drag) {
  if (!(drag.norm() <= kMostDrag))
    fail("drag: a vector of length up to {} expected, got ({}, {})", kMostDrag, drag.x(), drag.y());
  give_all(map.drag, map.solid, Eigen::Vector2f(0, 0));
  cells_in(map.solid, box, [&](Cell cell) { map.drag[cell] = drag.cast<float>(); });
  ++map.version;
}

PlanningProblem problem_on(const PlanningMap& map, const PlanningTask& task, const Work& work) {
  if (!(task.robot_radius >= 0) || !std::isfinite(task.robot_radius))
    fail("robot_radius: a number >= 0 [m] expected, got {}", task.robot_radius);
  const double radius = task.robot_radius / map.solid.frame.resolution;
  PlanningProblem problem =
      task.lattice == Lattice::hexagonal ? on_hexagons(map, radius, work) : on_squares(map, task, radius, work);
  problem.lattice = task.lattice;
  problem.robot_radius = radius;
  const auto cell = [&](const Vec2& point) { return cell_at(task.lattice, map.solid.frame.in_cells(point)); };
  if (task.start) problem.start = cell(*task.start);
  for (const Vec2& target : task.targets) problem.targets.push_back(cell(target));
  return problem;
}

Vec2 in_metres(const GridFrame& frame, const Vec2& cells) { return frame.origin * Vec2(cells * frame.resolution); }

}  // namespace meander
