// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meander {
namespace {

void check_size(const char* what, int width, int height, const Grid<std::uint8_t>& blocked) {
  if (width != blocked.width() || height != blocked.height())
    fail("{}: a grid of {} x {} cells expected, like the map, got {} x {}", what, blocked.width(), blocked.height(),
         width, height);
}

/// As the map counts cells, and in its frame.
std::string at(const PlanningProblem& problem, Cell cell) {
  const GridFrame& frame = problem.blocked.frame;
  const Vec2 place = frame.origin * Vec2(cell_center(problem.lattice, cell) * frame.resolution);
  return fmt::format("({}, {}) at ({:.2f}, {:.2f}) m", cell.x, cell.y, place.x(), place.y());
}

/// The cell of what stands there that holds this cell's centre.
Cell square_of(const PlanningProblem& problem, Cell cell) {
  const Vec2 center = cell_center(problem.lattice, cell);
  return {std::min(static_cast<int>(center.x()), problem.solid().width() - 1),
          std::min(static_cast<int>(center.y()), problem.solid().height() - 1)};
}

/// "" or why nobody can stand there.
std::string trouble(const PlanningProblem& problem, const char* what, Cell cell) {
  if (!problem.blocked.contains(cell))
    return fmt::format("{} in cell {} lies outside of the map of {} x {} cells", what, at(problem, cell),
                       problem.blocked.width(), problem.blocked.height());
  if (problem.blocked[cell] == 0) return {};
  if (problem.solid()[square_of(problem, cell)] == 0)
    return fmt::format("{} in cell {} is nearer to a wall than {}", what, at(problem, cell),
                       problem.robot_radius > 0 ? "the robot's radius" : "half a step");
  return fmt::format("{} in cell {} lies in a wall", what, at(problem, cell));
}

double asked_by(const PlanningProblem& problem, Cell cell, const Eigen::Vector2f& direction) {
  const double hard = problem.difficulty.cells().empty() ? 1.0 : static_cast<double>(problem.difficulty[cell]);
  const double dear = problem.drag.cells().empty() ? 0.0 : static_cast<double>(problem.drag[cell].dot(direction));
  return hard * (1 + dear);
}

}  // namespace

void validate(const PlanningProblem& problem) {
  constexpr double kRounding = 1e-6;  // to single precision
  const Grid<std::uint8_t>& map = problem.blocked;
  if (map.cells().empty()) fail("map: at least one cell expected, got {} x {}", map.width(), map.height());
  if (problem.targets.empty()) fail("targets: at least one expected, got none");
  if (!(problem.robot_radius >= 0) || !std::isfinite(problem.robot_radius))
    fail("robot_radius: a number >= 0 expected, got {}", problem.robot_radius);
  if (!problem.obstacles.cells().empty() && problem.lattice != Lattice::hexagonal)
    check_size("obstacles", problem.obstacles.width(), problem.obstacles.height(), map);
  if (!problem.difficulty.cells().empty())
    check_size("difficulty", problem.difficulty.width(), problem.difficulty.height(), map);
  if (!problem.drag.cells().empty()) check_size("drag", problem.drag.width(), problem.drag.height(), map);
  for (const float hard : problem.difficulty.cells())
    if (!(hard >= static_cast<float>(kLeastDifficulty) && hard <= static_cast<float>(kMostDifficulty)))
      fail("difficulty: numbers from {} to {} expected, got {}", kLeastDifficulty, kMostDifficulty, hard);
  for (const Eigen::Vector2f& drag : problem.drag.cells())
    if (!(static_cast<double>(drag.norm()) <= kMostDrag + kRounding))
      fail("drag: vectors of length up to {} expected, got ({}, {})", kMostDrag, drag.x(), drag.y());
}

std::string bad_place_reason(const PlanningProblem& problem) {
  validate(problem);
  if (free_targets(problem).empty()) {
    const std::string first = trouble(problem, "the target", problem.targets.front());
    return problem.targets.size() == 1 ? first : fmt::format("no target can be stood on: {}", first);
  }
  return problem.start ? trouble(problem, "the start", *problem.start) : std::string();
}

std::string cut_off_reason(const PlanningProblem& problem) {
  return fmt::format("the start in cell {} is cut off from {}", at(problem, *problem.start),
                     problem.targets.size() == 1 ? "the target in cell " + at(problem, problem.targets.front())
                                                 : fmt::format("all {} targets", problem.targets.size()));
}

std::string no_path_reason(const PlanningProblem& problem, const Work& work) {
  if (std::string bad = bad_place_reason(problem); !bad.empty()) return bad;
  if (problem.start && reachable_cells(problem, work)[*problem.start] == 0) return cut_off_reason(problem);
  return {};
}

std::vector<Cell> free_targets(const PlanningProblem& problem) {
  std::vector<Cell> targets;
  for (const Cell target : problem.targets)
    if (problem.blocked.at(target, 1) == 0) targets.push_back(target);
  return targets;
}

Grid<std::uint8_t> reachable_cells(const PlanningProblem& problem, const Work& work) {
  const Grid<std::uint8_t>& blocked = problem.blocked;
  Grid<std::uint8_t> reached(blocked.width(), blocked.height(), 0, blocked.frame);
  std::vector<Cell> open;
  for (const Cell target : free_targets(problem))
    if (std::exchange(reached[target], std::uint8_t{1}) == 0) open.push_back(target);
  for (std::size_t count = 0; !open.empty(); ++count) {
    if (count % 8192 == 0) work.poll();
    const Cell cell = open.back();
    open.pop_back();
    for (const LatticeStep& step : lattice_steps(problem.lattice, cell.y)) {
      const Cell next{cell.x + step.dx, cell.y + step.dy};
      if (reached.at(next, 1) != 0 || !open_step(blocked, problem.corners, cell, step)) continue;
      reached[next] = 1;
      open.push_back(next);
    }
  }
  return reached;
}

double step_cost(const PlanningProblem& problem, Cell from, const LatticeStep& step) {
  if (problem.even()) return step.length;
  const Cell to{from.x + step.dx, from.y + step.dy};
  const Vec2 way = cell_center(problem.lattice, to) - cell_center(problem.lattice, from);
  const Eigen::Vector2f direction = (way / step.length).cast<float>();
  return step.length * (asked_by(problem, from, direction) + asked_by(problem, to, direction)) / 2;
}

double least_difficulty(const PlanningProblem& problem) {
  if (problem.even()) return 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < problem.blocked.cells().size(); ++i) {
    if (problem.blocked.cells()[i] != 0) continue;
    const double hard = problem.difficulty.cells().empty() ? 1.0 : static_cast<double>(problem.difficulty.cells()[i]);
    const double drag = problem.drag.cells().empty() ? 0.0 : static_cast<double>(problem.drag.cells()[i].norm());
    least = std::min(least, hard * (1 - drag));
  }
  return least;
}

Grid<std::uint8_t> blocked_for(const Grid<std::uint8_t>& solid, double radius, const Work& work) {
  if (!(radius >= 0) || !std::isfinite(radius)) fail("robot_radius: a number >= 0 expected, got {}", radius);
  if (radius <= 0.5) return solid;  // steps that keep corners have half a cell on all sides
  const int width = solid.width(), height = solid.height();
  const double reach = std::sqrt(radius * radius + 0.5);
  // The rim is a wall: in a map that is narrower than the robot nobody can stand anywhere.
  if ((std::min(width, height) - 1) / 2 + 0.5 < reach) return Grid<std::uint8_t>(width, height, 1, solid.frame);
  const int rows = static_cast<int>(std::ceil(reach + 0.5)) - 1;
  Grid<std::uint8_t> blocked(width, height, 0, solid.frame);
  std::vector<int> near(static_cast<std::size_t>(width));  // columns to the nearest solid cell of the row
  for (int y = -rows; y < height + rows; ++y) {
    work.poll();
    const bool rim = y < 0 || y >= height;
    for (int x = 0, last = -1; x < width; ++x) {
      if (rim || solid[{x, y}] != 0) last = x;
      near[static_cast<std::size_t>(x)] = x - last;
    }
    for (int x = width - 1, last = width; x >= 0; --x) {
      if (rim || solid[{x, y}] != 0) last = x;
      near[static_cast<std::size_t>(x)] = std::min(near[static_cast<std::size_t>(x)], last - x);
    }
    for (int dy = -rows; dy <= rows; ++dy) {
      const int row = y + dy;
      if (row < 0 || row >= height) continue;
      const double down = std::max(std::abs(dy) - 0.5, 0.0);
      const double across = std::sqrt(std::max(reach * reach - down * down, 0.0)) + 0.5;
      for (int x = 0; x < width; ++x)
        if (near[static_cast<std::size_t>(x)] < across) blocked[{x, row}] = 1;
    }
  }
  return blocked;
}

}  // namespace meander
