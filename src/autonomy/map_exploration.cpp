// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Who chooses where to go on the sonar explorer's map without a graph.
#include "autonomy/sonar_explorer.hpp"
#include "indicator/grid_way.hpp"

namespace meander {
namespace {

constexpr double kGivenUp = 30;  ///< evidence for a wall where a frontier was looked at and stayed one

}  // namespace

/// What the others do that the rules are compared with: they see the same map, and keep no graph.
void SonarExplorer::decide_without_graph() {
  if (options_.explorer.budget > 0 && walked_ > options_.explorer.budget)
    return end(Ending::budget, fmt::format("the budget of {:g} m is spent", options_.explorer.budget));
  if (options_.strategy == ExplorationStrategy::dstar_lite) {
    if (!way_by_dstar_lite().empty()) return drive_to(Toward::frontier, goal_);
  } else if (decide_by_frontier()) {
    return;
  }
  look_again();
}

/// The frontier that is nearest by the way, or by the way and as the crow flies from there to the goal.
bool SonarExplorer::decide_by_frontier() {
  const ConfigurationSpace& space = map_.space();
  const double straight_on = options_.strategy == ExplorationStrategy::goal_frontier ? 1 : 0;
  for (;;) {
    field_.spread(space, space.frame().cell(standing()), 1e9);
    std::optional<Cell> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Cell cell : field_.reached()) {
      const Vec2 there = space.frame().center(cell);
      const double cost = field_.at(cell) + straight_on * (there - goal_).norm();
      if (cost >= least || !(space.frontier(cell) || cell == space.frame().cell(goal_))) continue;
      least = cost;
      best = cell;
    }
    if (!best) return false;
    const Vec2 place = space.frame().center(*best);
    if ((place - at_).norm() > options_.arrive) {
      drive_to(*best == space.frame().cell(goal_) ? Toward::goal : Toward::frontier, place);
      return true;
    }
    for (const Cell beside : {Cell{best->x + 1, best->y}, Cell{best->x - 1, best->y}, Cell{best->x, best->y + 1},
                              Cell{best->x, best->y - 1}})
      if (space.known(beside) == Known::nothing) map_.add(beside, kGivenUp);  // it stands there and cannot tell
  }
}

/// From where the robot stands, or from the nearest place where nothing speaks against its standing.
std::vector<Cell> SonarExplorer::way_by_dstar_lite() {
  const ConfigurationSpace& space = map_.space();
  const auto here = nearest_open(space, at_, kSnap);
  if (!here) return {};
  return free_space_.plan(space, *here, space.frame().cell(goal_));
}

}  // namespace meander
