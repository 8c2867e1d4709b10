// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <vector>

#include "base/random.hpp"
#include "planning/problem.hpp"

namespace meander::neural_maps {

using Map = Grid<std::uint8_t>;

inline Map open_floor(int width, int height) { return Map(width, height, 0); }

inline Map clutter(int width, int height, double share, std::uint64_t seed) {
  Stream random(seed, "clutter");
  Map map(width, height, 0);
  for (std::uint8_t& cell : map.cells()) cell = random.chance(share) ? 1 : 0;
  return map;
}

/// Rooms of `pitch` - 1 cells, two doors each, two cells wide.
inline Map rooms(int width, int height, int pitch, std::uint64_t seed) {
  Stream random(seed, "rooms");
  Map map(width, height, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) map[{x, y}] = x % pitch == pitch - 1 || y % pitch == pitch - 1 ? 1 : 0;
  const auto open = [&](Cell cell) {
    if (map.contains(cell)) map[cell] = 0;
  };
  for (int y = 0; y < height; y += pitch)
    for (int x = 0; x < width; x += pitch) {
      const int right = random.below(pitch - 2), up = random.below(pitch - 2);
      for (int i = 0; i < 2; ++i) open({x + pitch - 1, y + right + i}), open({x + up + i, y + pitch - 1});
    }
  return map;
}

/// One long way to and fro, `lane` cells wide.
inline Map serpentine(int width, int height, int lane) {
  Map map(width, height, 0);
  bool low = false;
  for (int x = lane; x < width; x += lane + 1, low = !low)
    for (int y = 0; y < height; ++y) map[{x, y}] = (low ? y < lane : y >= height - lane) ? 0 : 1;
  return map;
}

/// Corridors one cell wide, exactly one way between any two cells. Width and height are odd.
inline Map perfect_maze(int width, int height, std::uint64_t seed) {
  Stream random(seed, "maze");
  Map map(width, height, 1);
  std::vector<Cell> way{{1, 1}};
  map[{1, 1}] = 0;
  while (!way.empty()) {
    const Cell here = way.back();
    std::vector<Cell> next;
    for (const Cell step : {Cell{2, 0}, Cell{-2, 0}, Cell{0, 2}, Cell{0, -2}})
      if (const Cell cell{here.x + step.x, here.y + step.y}; map.at(cell, 0) != 0) next.push_back(cell);
    if (next.empty()) {
      way.pop_back();
      continue;
    }
    const Cell cell = next[static_cast<std::size_t>(random.below(static_cast<int>(next.size())))];
    map[{(here.x + cell.x) / 2, (here.y + cell.y) / 2}] = 0;
    map[cell] = 0;
    way.push_back(cell);
  }
  return map;
}

struct NamedMap {
  std::string name;
  Map map;
};

inline std::vector<NamedMap> maps_of_all_kinds(int size, std::uint64_t seed) {
  return {{"open", open_floor(size, size)},
          {"clutter 20 %", clutter(size, size, 0.2, seed)},
          {"clutter 35 %", clutter(size, size, 0.35, seed)},
          {"rooms", rooms(size, size, 13, seed)},
          {"serpentine", serpentine(size, size, 3)},
          {"maze", perfect_maze(size | 1, size | 1, seed)}};
}

/// With the target at a random free cell.
inline PlanningProblem problem_on(Map map, std::uint64_t seed) {
  Stream random(seed, "target");
  Cell target;
  do target = {random.below(map.width()), random.below(map.height())};
  while (map[target] != 0);
  return {.blocked = std::move(map), .targets = {target}};
}

}  // namespace meander::neural_maps
