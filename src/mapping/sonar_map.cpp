// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/sonar_map.hpp"

#include "mapping/log_odds.hpp"

namespace meander {

double SonarMap::probability(const Vec2& point) const {
  const Cell cell = local_.cell(point);
  // A place that has come back into the window is known to the global map alone.
  const float near = local_.covers(cell) ? local_.log_odds(cell) : 0;
  return static_cast<double>(probability_of(near != 0 || !global_ ? near : global_->log_odds(cell)));
}

Grid<float> SonarMap::probabilities(MapPart part) const {
  if (part == MapPart::global && !global_) fail("this map keeps no global map, only the local one");
  Grid<float> grid = part == MapPart::local ? local_.log_odds() : global_->log_odds();
  for (float& cell : grid.cells()) cell = probability_of(cell);
  return grid;
}

}  // namespace meander
