// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/flood.hpp"

#include <span>

namespace meander {

Components components(const Grid<std::uint8_t>& open, Neighbours neighbours) {
  static constexpr Cell kSteps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const std::span<const Cell> steps(kSteps, neighbours == Neighbours::four ? 4 : 8);
  Components result{Grid<std::int32_t>(open.width(), open.height(), -1, open.frame), {}};
  std::vector<Cell> waiting;
  const auto enter = [&](Cell cell, std::int32_t label) {
    if (!open.contains(cell) || !open[cell] || result.label[cell] >= 0) return;
    result.label[cell] = label;
    ++result.cells[static_cast<std::size_t>(label)];
    waiting.push_back(cell);
  };
  for (int y = 0; y < open.height(); ++y)
    for (int x = 0; x < open.width(); ++x) {
      if (!open[{x, y}] || result.label[{x, y}] >= 0) continue;
      const auto label = static_cast<std::int32_t>(result.cells.size());
      result.cells.push_back(0);
      enter({x, y}, label);
      while (!waiting.empty()) {
        const Cell cell = waiting.back();
        waiting.pop_back();
        for (const Cell& step : steps) enter({cell.x + step.x, cell.y + step.y}, label);
      }
    }
  return result;
}

}  // namespace meander
