// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/merge_cells.hpp"

#include <map>
#include <tuple>

namespace meander {
namespace {

struct Run {
  int x, width;
  Color color;
  std::size_t group, block;
};

/// Runs of equal visible colour in one row.
std::vector<Run> runs_of(const DrawCells& cells, int row) {
  std::vector<Run> runs;
  const Color* colors = &cells.colors[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.width)];
  for (int x = 0; x < cells.width; ++x) {
    if (colors[x].a == 0) continue;
    if (!runs.empty() && runs.back().x + runs.back().width == x && runs.back().color == colors[x])
      ++runs.back().width;
    else
      runs.push_back({x, 1, colors[x], 0, 0});
  }
  return runs;
}

}  // namespace

std::vector<CellGroup> merged_cells(const DrawCells& cells) {
  std::vector<CellGroup> groups;
  std::map<std::tuple<int, int, int, int>, std::size_t> group_of;
  std::vector<Run> below;
  for (int y = 0; y < cells.height; ++y) {
    std::vector<Run> runs = runs_of(cells, y);
    auto candidate = below.begin();
    for (Run& run : runs) {
      while (candidate != below.end() && candidate->x < run.x) ++candidate;
      if (candidate != below.end() && candidate->x == run.x && candidate->width == run.width &&
          candidate->color == run.color) {
        run.group = candidate->group, run.block = candidate->block;
        ++groups[run.group].blocks[run.block].height;
        continue;
      }
      const auto [at, fresh] =
          group_of.try_emplace({run.color.r, run.color.g, run.color.b, run.color.a}, groups.size());
      if (fresh) groups.push_back({run.color, {}});
      run.group = at->second, run.block = groups[run.group].blocks.size();
      groups[run.group].blocks.push_back({run.x, y, run.width, 1});
    }
    below = std::move(runs);
  }
  return groups;
}

}  // namespace meander
