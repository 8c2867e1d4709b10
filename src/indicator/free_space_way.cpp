// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/free_space_way.hpp"

#include <algorithm>

namespace meander {

const std::vector<Cell>& FreeSpaceWay::plan(const ConfigurationSpace& space, Cell start, Cell goal) {
  if (!planner_ || !(goal == goal_)) {
    planner_.emplace(space.width(), space.height(), goal);
    goal_ = goal;
    version_ = 0;
    resolution_ = space.resolution();
  }
  follow(space);
  return planner_->plan(start);
}

/// Tells the planner of the cells that have changed, where any have.
void FreeSpaceWay::follow(const ConfigurationSpace& space) {
  constexpr int kBlock = 16;
  if (version_ == space.version()) return;
  for (int top = 0; top < space.height(); top += kBlock)
    for (int left = 0; left < space.width(); left += kBlock) {
      const int right = std::min(left + kBlock, space.width()), bottom = std::min(top + kBlock, space.height());
      if (version_ > 0 && space.changed({left, top}, {right - 1, bottom - 1}) <= version_) continue;
      for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) planner_->set_blocked({x, y}, !space.open({x, y}));
    }
  version_ = space.version();
}

}  // namespace meander
