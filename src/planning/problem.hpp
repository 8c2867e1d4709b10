// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/work.hpp"
#include "planning/lattice.hpp"

namespace meander {

/// What single precision can still add up along a way.
inline constexpr double kLeastDifficulty = 0.001, kMostDifficulty = 1000, kMostDrag = 0.999;

/// What every planner is given. Points and lengths are in cells of the grid; its frame leads to metres.
struct PlanningProblem {
  Grid<std::uint8_t> blocked;   ///< not 0: the robot's centre must not be there
  std::vector<Cell> targets;    ///< at least one; the path leads to the one that is easiest to reach
  std::optional<Cell> start{};  ///< searches need it, landscapes do not

  /// How hard a cell is: the cost of a way through it for each cell of length. Empty: 1 everywhere. Else from
  /// kLeastDifficulty to kMostDifficulty.
  Grid<float> difficulty{};
  /// Inclines and preferred ways: a step in the direction u costs 1 + drag . u times as much, so it is dear along the
  /// vector and cheap against it. Empty: none. Else |drag| <= kMostDrag.
  Grid<Eigen::Vector2f> drag{};

  Corners corners = Corners::keep;
  Lattice lattice = Lattice::rectangular;

  /// What stands there, when `blocked` was inflated from it for a robot of this radius: certificates and clearances of
  /// paths ask this grid. Empty: `blocked` itself.
  Grid<std::uint8_t> obstacles{};
  double robot_radius = 0;  ///< [cells]

  const Grid<std::uint8_t>& solid() const { return obstacles.cells().empty() ? blocked : obstacles; }
  bool even() const { return difficulty.cells().empty() && drag.cells().empty(); }  ///< cost is length
};

/// Throws ArgumentError: an empty grid, no target, grids of different size, a difficulty or a drag out of its
/// range, a radius < 0.
void validate(const PlanningProblem& problem);

/// Why there cannot be a path, in words: the start or all targets outside of the map or in a wall. Empty otherwise.
/// Asks `start` only where it is given. Calls validate().
std::string bad_place_reason(const PlanningProblem& problem);
/// The same, and whether a way leads from the start to a target.
std::string no_path_reason(const PlanningProblem& problem, const Work& work = {});
std::string cut_off_reason(const PlanningProblem& problem);

/// The targets that are inside and free.
std::vector<Cell> free_targets(const PlanningProblem& problem);

/// 1 for every cell from which a target can be reached, targets included.
Grid<std::uint8_t> reachable_cells(const PlanningProblem& problem, const Work& work = {});

/// What the step costs: its length times the mean of what both cells ask in this direction.
double step_cost(const PlanningProblem& problem, Cell from, const LatticeStep& step);

/// Least cost of a cell of length anywhere: what a search may take for granted.
double least_difficulty(const PlanningProblem& problem);

/// The cells that a robot of `radius` [cells] cannot stand on: so near to a solid cell or to the rim that a step
/// between two cells that are left keeps the whole robot clear of them, diagonal steps too. [LM99+] sqrt(radius^2 +
/// 1/2) from a cell's centre to the solid square: the paper takes the map of configurations as given.
Grid<std::uint8_t> blocked_for(const Grid<std::uint8_t>& solid, double radius, const Work& work = {});

}  // namespace meander
