// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/random.hpp"
#include "planning/problem.hpp"

namespace meander {

/// A problem drawn with characters, top row first: # wall, T target, S start, all else free.
inline PlanningProblem drawn_problem(const std::vector<std::string>& rows) {
  const int height = static_cast<int>(rows.size()), width = height > 0 ? static_cast<int>(rows.front().size()) : 0;
  PlanningProblem problem{.blocked = Grid<std::uint8_t>(width, height), .targets = {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const char c = rows[static_cast<std::size_t>(height - 1 - y)][static_cast<std::size_t>(x)];
      problem.blocked[{x, y}] = c == '#';
      if (c == 'T') problem.targets.push_back({x, y});
      if (c == 'S') problem.start = Cell{x, y};
    }
  return problem;
}

/// Cells blocked with a probability, one or two free targets.
inline PlanningProblem random_problem(std::uint64_t seed, int width, int height, double density) {
  Stream stream(seed, "map");
  PlanningProblem problem{.blocked = Grid<std::uint8_t>(width, height), .targets = {}};
  for (std::uint8_t& cell : problem.blocked.cells()) cell = stream.chance(density);
  for (int i = 0; i <= static_cast<int>(seed % 2); ++i) {
    const Cell target{stream.below(width), stream.below(height)};
    problem.blocked[target] = 0;
    problem.targets.push_back(target);
  }
  return problem;
}

/// Difficulties from 0.3 to 8 and drags of up to 0.9 in any direction.
inline void add_terrain(PlanningProblem& problem, std::uint64_t seed) {
  Stream stream(seed, "terrain");
  const int width = problem.blocked.width(), height = problem.blocked.height();
  problem.difficulty = Grid<float>(width, height);
  problem.drag = Grid<Eigen::Vector2f>(width, height, Eigen::Vector2f::Zero());
  for (float& hard : problem.difficulty.cells()) hard = static_cast<float>(stream.uniform(0.3, 8));
  for (Eigen::Vector2f& drag : problem.drag.cells())
    drag = {static_cast<float>(stream.uniform(-0.6, 0.6)), static_cast<float>(stream.uniform(-0.6, 0.6))};
}

}  // namespace meander
