// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Who chooses where to go on the sonar explorer's map without a graph.
#include <algorithm>

#include "autonomy/sonar_explorer.hpp"
#include "indicator/grid_way.hpp"

namespace meander {
namespace {

constexpr int kSpeck = 3;        ///< fewer frontier cells near each other than so many are no frontier
constexpr double kGivenUp = 30;  ///< evidence for a wall where a frontier was looked at and stayed one

bool is_speck(const ConfigurationSpace& space, Cell cell) {
  int near = 0;
  for (int y = cell.y - 2; y <= cell.y + 2; ++y)
    for (int x = cell.x - 2; x <= cell.x + 2; ++x) near += space.frontier({x, y});
  return near < kSpeck;
}

}  // namespace

/// What the others do that the rules are compared with: they see the same map, and keep no graph.
void SonarExplorer::decide_without_graph(bool blocked) {
  if ((at_ - goal_).norm() <= options_.arrive) return end(Ending::reached, "the goal is reached");
  if (options_.explorer.budget > 0 && walked_ > options_.explorer.budget)
    return end(Ending::budget, fmt::format("the budget of {:g} m is spent", options_.explorer.budget));
  const bool tried = toward_ == Toward::frontier && (blocked || is_there());
  toward_ = Toward::nothing;
  if (options_.strategy == ExplorationStrategy::dstar_lite) {
    if (!way_by_dstar_lite().empty()) return drive_to(Toward::frontier, goal_);
    return look_again();
  }
  if (tried) give_up_frontier(aim_);
  if (!decide_by_frontier()) look_again();
}

/// It did not get there, or stood there and cannot tell what is beyond.
void SonarExplorer::give_up_frontier(const Vec2& place) {
  const ConfigurationSpace& space = map_.space();
  const Cell cell = space.frame().cell(place);
  for (const Cell beside :
       {Cell{cell.x + 1, cell.y}, Cell{cell.x - 1, cell.y}, Cell{cell.x, cell.y + 1}, Cell{cell.x, cell.y - 1}})
    if (space.known(beside) == Known::nothing) map_.add(beside, kGivenUp);
}

/// The frontier that is nearest by the way, or by the way and as the crow flies from there to the goal.
bool SonarExplorer::decide_by_frontier() {
  const ConfigurationSpace& space = map_.space();
  const double straight_on = options_.strategy == ExplorationStrategy::goal_frontier ? 1 : 0;
  field_.spread(space, space.frame().cell(standing()), 1e9);
  const std::vector<Cell> goals = cells_at(space, goal_, options_.arrive, false);
  const auto is_goal = [&](Cell cell) { return std::find(goals.begin(), goals.end(), cell) != goals.end(); };
  std::optional<Cell> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Cell cell : field_.reached()) {
    const Vec2 there = space.frame().center(cell);
    const double cost = field_.at(cell) + straight_on * (there - goal_).norm();
    if (cost >= least || !(is_goal(cell) || (space.frontier(cell) && !is_speck(space, cell)))) continue;
    least = cost;
    best = cell;
  }
  if (!best) return false;
  if (is_goal(*best))
    drive_to(Toward::goal, goal_);
  else
    drive_to(Toward::frontier, space.frame().center(*best));
  return true;
}

/// From where the robot stands, or from the nearest place where nothing speaks against its standing.
std::vector<Cell> SonarExplorer::way_by_dstar_lite() {
  const ConfigurationSpace& space = map_.space();
  const auto here = nearest_open(space, at_, kSnap), goal = nearest_open(space, goal_, options_.arrive);
  if (!here || !goal) return {};
  return free_space_.plan(space, *here, *goal);
}

}  // namespace meander
