// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/configuration_space.hpp"

#include <cmath>

namespace meander {

ConfigurationSpace::ConfigurationSpace(int width, int height, const GridFrame& frame, double reach)
    : known_(width, height, Known::nothing, frame), walls_near_(width, height, 0, frame) {
  if (!(frame.resolution > 0) || !(reach >= 0) || !(reach < 1000 * frame.resolution))
    fail("map: cells of a side > 0 and a reach of 0 to 1000 of them expected, got {} and {} m", frame.resolution,
         reach);
  const int cells = static_cast<int>(reach / frame.resolution);
  const double most = reach * reach / (frame.resolution * frame.resolution);
  for (int y = -cells; y <= cells; ++y)
    for (int x = -cells; x <= cells; ++x)
      if (x * x + y * y <= most) disc_.push_back({x, y});
}

void ConfigurationSpace::set(Cell cell, Known known) {
  if (!known_.contains(cell)) return;
  const int change = int{known == Known::wall} - int{known_[cell] == Known::wall};
  known_[cell] = known;
  if (change == 0) return;
  for (const Cell offset : disc_) {
    const Cell near{cell.x + offset.x, cell.y + offset.y};
    if (walls_near_.contains(near)) walls_near_[near] += change;
  }
}

bool ConfigurationSpace::frontier(Cell cell) const {
  if (!free(cell)) return false;
  for (const Cell beside :
       {Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y + 1}, Cell{cell.x - 1, cell.y}, Cell{cell.x, cell.y - 1}})
    if (known(beside) == Known::nothing && open(beside)) return true;
  return false;
}

}  // namespace meander
