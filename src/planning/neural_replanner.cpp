// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_replanner.hpp"

#include <algorithm>
#include <utility>

#include "planning/neural_tiles.hpp"

namespace meander {

NeuralReplanner::NeuralReplanner(PlanningProblem problem, const NeuralMapOptions& options, const Work& work)
    : problem_(std::move(problem)), options_(options) {
  meander::validate(options_);
  meander::validate(problem_);
  if (options_.solver != NeuralSolver::tiles && options_.solver != NeuralSolver::active_list)
    fail("solver: 'tiles' or 'active_list' expected to follow edits, got '{}'", to_string(options_.solver));
  if (options_.extent != NeuralExtent::map)
    fail("extent: 'map' expected to follow edits, got '{}'", to_string(options_.extent));
  solve(work);
}

void NeuralReplanner::solve(const Work& work) {
  tiles_.reset();
  TileMap map;
  if (fits_tiles(problem_, options_) && !is_maze(map = tile_map(problem_, work))) {
    tiles_ = std::make_unique<TileSolver>(std::move(map), options_, *tile_kernels().back());
    tiles_->solve(problem_, work);
    tiles_->expect_edits(problem_);
    settled_ = true;
    return;
  }
  net_ = neural_net(problem_, options_, work);
  solution_ = solve_active_list(net_, options_, work);
  settled_ = true;
}

void NeuralReplanner::edit(std::span<const CellEdit> edits, const Work& work) {
  for (const CellEdit& edit : edits)
    if (!problem_.blocked.contains(edit.cell))
      fail("edit: a cell of the map of {} x {} cells expected, got ({}, {})", problem_.blocked.width(),
           problem_.blocked.height(), edit.cell.x, edit.cell.y);
  for (const CellEdit& edit : edits) problem_.blocked[edit.cell] = edit.blocked ? 1 : 0;
  // Weights that differ may have another largest sum now, and all of the map another beta.
  if (!std::exchange(settled_, false) || !problem_.even()) return solve(work);
  tiles_ ? edit_tiles(edits, work) : edit_net(edits, work);
  settled_ = true;
}

void NeuralReplanner::edit_tiles(std::span<const CellEdit> edits, const Work& work) {
  std::vector<std::int32_t> tiles;
  for (const CellEdit& edit : edits) tiles.push_back(tiles_->tile_of(edit.cell));
  tiles_->follow(problem_, std::move(tiles), work);
}

void NeuralReplanner::edit_net(std::span<const CellEdit> edits, const Work& work) {
  solution_.relaxations = 0;
  std::vector<std::int32_t> changed = drop_unsupported(relink_around(edits), work);
  settle(net_, solution_, std::move(changed), options_.tolerance, work);
}

/// The units whose connections may have changed.
std::vector<std::int32_t> NeuralReplanner::relink_around(std::span<const CellEdit> edits) {
  std::vector<std::int32_t> units;
  for (const auto& [cell, blocked] : edits)
    for (int dy = -NeuralNet::kRim; dy <= NeuralNet::kRim; ++dy)
      for (int dx = -NeuralNet::kRim; dx <= NeuralNet::kRim; ++dx)
        if (const Cell near{cell.x + dx, cell.y + dy}; problem_.blocked.contains(near)) {
          relink(net_, problem_, near);
          units.push_back(net_.index(near));
        }
  for (const Cell target : problem_.targets) {
    if (!problem_.blocked.contains(target)) continue;
    const std::int32_t i = net_.index(target);
    const bool free = problem_.blocked[target] == 0;
    std::uint32_t& links = net_.links[static_cast<std::size_t>(i)];
    if (free == ((links & NeuralNet::kTarget) != 0)) continue;
    links ^= NeuralNet::kTarget;
    solution_.v[static_cast<std::size_t>(i)] = free ? Extended{1, 0} : Extended{};
    net_.for_each_link(i, [&](std::int32_t j, int) { units.push_back(j); });
  }
  return units;
}

/// [LM99+] Reachability first: activation that has lost what held it up goes to 0 at once and is built up anew; by
/// updates alone a region that was cut off would decay for ever. A unit is dropped whose equation gives it less than
/// (1 + 19 s) / 20 of what it has. In a region without a source the unit of most activation gets at most s of it, so
/// nothing is left of such a region. Returns the units to be settled.
std::vector<std::int32_t> NeuralReplanner::drop_unsupported(std::vector<std::int32_t> changed, const Work& work) {
  const double least = (1 + 19 * options_.steepness) / 20;
  std::vector<std::int32_t> settle = changed;
  for (std::size_t count = 0; !changed.empty(); ++count) {
    if (count % 4096 == 0) work.poll();
    const std::int32_t i = changed.back();
    changed.pop_back();
    Extended& own = solution_.v[static_cast<std::size_t>(i)];
    if (own.zero() || net_.is_target(i)) continue;
    const Extended u = response(net_, solution_.v, i);
    // Where its own block is two above, in_block() is 0 and it has lost nearly all.
    if (!u.zero() && own.block <= u.block + 1 && u.value >= least * own.in_block(u.block)) continue;
    own = {};
    settle.push_back(i);
    net_.for_each_link(i, [&](std::int32_t j, int) { changed.push_back(j), settle.push_back(j); });
  }
  std::sort(settle.begin(), settle.end());
  settle.erase(std::unique(settle.begin(), settle.end()), settle.end());
  return settle;
}

}  // namespace meander
