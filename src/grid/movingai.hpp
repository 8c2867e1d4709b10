// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "grid/grid.hpp"

namespace meander {

/// A map of movingai.com/benchmarks. The file's first line is the top row of the grid.
struct MovingAiMap {
  Grid<std::uint8_t> blocked;  ///< 0 for ground and swamp, 1 for trees, water and what is out of bounds
  std::size_t water = 0;       ///< cells of it: passable from water only
  std::size_t swamp = 0;
};

/// Throws FileError "name:line: what was expected": `type octile`, `height`, `width`, `map`, then the rows.
MovingAiMap movingai_map(const std::string& text, const std::string& name);
MovingAiMap read_movingai_map(const std::string& path);

/// One task of a scenario file. Cells count from the lower left, as in the grid.
struct MovingAiScenario {
  int bucket = 0;
  std::string map;  ///< as written
  Cell start, goal;
  double length = 0;  ///< of the shortest way over 8 neighbours without cutting corners, as published [cells]
};

/// The tasks for a map of this height. Throws FileError "name:line: what was expected"; the sizes that a line tells
/// must be those of the map.
std::vector<MovingAiScenario> movingai_scenarios(const std::string& text, const std::string& name, int width,
                                                 int height);
std::vector<MovingAiScenario> read_movingai_scenarios(const std::string& path, int width, int height);

}  // namespace meander
