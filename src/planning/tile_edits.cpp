// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// How a solution follows edits of the map: only what changes is computed anew.
#include <algorithm>
#include <utility>

#include "planning/tile_solver.hpp"

namespace meander {
namespace {

constexpr std::int32_t kNoWay = std::numeric_limits<std::int32_t>::max();
constexpr std::uint8_t kAllSides = 0xf;

void each_once(std::vector<std::int32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// These tiles and all around them.
std::vector<std::int32_t> with_neighbours(const TileMap& map, const std::vector<std::int32_t>& tiles) {
  std::vector<std::int32_t> all;
  for (const std::int32_t t : tiles)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) all.push_back(t + dy * map.across + dx);
  each_once(all);
  return all;
}

}  // namespace

void TileSolver::follow(const PlanningProblem& problem, std::vector<std::int32_t> tiles, const Work& work) {
  relaxations_ = 0;
  queue_ = {};
  each_once(tiles);
  recut_tiles(problem, tiles);
  forget_the_lost(problem);
  for (const std::int32_t t : with_neighbours(map_, tiles))
    map_.for_each_unit(map_.slot[static_cast<std::size_t>(t)], [&](std::int32_t u, const TileUnit&) { wake(u); });
  settle(work);
}

void TileSolver::recut_tiles(const PlanningProblem& problem, const std::vector<std::int32_t>& tiles) {
  for (const std::int32_t t : tiles) recut(map_, problem, t);
  for (const std::int32_t t : with_neighbours(map_, tiles)) reconnect(map_, t);
  std::size_t live = 0;
  for (const TileUnit& one : map_.units) live += one.size > 0 ? 1 : 0;
  if (map_.units.size() > 2 * live + 64) compact(map_);
  taken_.resize(map_.tile.size(), 0);
  restore_curves(problem, tiles);
  awake_ = 0;
  for (const TileUnit& one : map_.units) awake_ += one.exponent != TileUnit::kAsleep ? 1 : 0;
}

/// Units near to targets whose tiles were cut anew know nothing of the bend.
void TileSolver::restore_curves(const PlanningProblem& problem, const std::vector<std::int32_t>& tiles) {
  std::vector<TileCurve> kept;
  for (TileUnit& one : map_.units) {
    if (one.size == 0 || one.curve < 0) continue;
    kept.push_back(curves_[static_cast<std::size_t>(one.curve)]);
    one.curve = static_cast<std::int32_t>(kept.size()) - 1;
  }
  curves_ = std::move(kept);
  for (const std::int32_t t : tiles)
    map_.for_each_unit(map_.slot[static_cast<std::size_t>(t)], [&](std::int32_t u, const TileUnit& one) {
      if (one.exponent != TileUnit::kAsleep && step_.is_steep(one)) curve_of(unit(u));
    });
  for (const Cell target : free_targets(problem))
    if (std::binary_search(tiles.begin(), tiles.end(), map_.tile_of(target))) plant(target);
}

/// Units on the way from each to the nearest target, itself included.
std::vector<std::int32_t> TileSolver::count_hops(const PlanningProblem& problem) const {
  std::vector<std::int32_t> hops(map_.units.size(), kNoWay), order;
  for (const Cell target : free_targets(problem))
    if (const std::int32_t u = unit_of(target); std::exchange(hops[static_cast<std::size_t>(u)], 1) != 1)
      order.push_back(u);
  for (std::size_t i = 0; i < order.size(); ++i)
    for_each_neighbour(map_, map_.units[static_cast<std::size_t>(order[i])], [&](std::int32_t u) {
      std::int32_t& own = hops[static_cast<std::size_t>(u)];
      if (own != kNoWay) return;
      own = hops[static_cast<std::size_t>(order[i])] + 1;
      order.push_back(u);
    });
  return hops;
}

void TileSolver::expect_edits(const PlanningProblem& problem) {
  const std::vector<std::int32_t> hops = count_hops(problem);
  for (std::size_t u = 0; u < hops.size(); ++u) map_.units[u].hops = hops[u];
}

void TileSolver::forget(std::int32_t number) {
  TileUnit& lost = unit(number);
  TileCells& cells = map_.cells_of(lost.slot);
  for (int r = 0; r < kTile; ++r) {
    for (int x = 0; x < kTile; ++x)
      if ((lost.rows[static_cast<std::size_t>(r)] >> x & 1) != 0) cells.cell[r][x] = 0;
    cells.side[0][r] = cells.cell[r][0];
    cells.side[1][r] = cells.cell[r][kTile - 1];
  }
  lost.exponent = TileUnit::kAsleep;
  lost.curve = -1;
  lost.key = std::numeric_limits<std::int32_t>::max();
  --awake_;
}

/// [LM99+] Reachability first: by updates alone a region that was cut off would decay for ever, and one that is now
/// reached by a longer way nearly as long. Units whose way has become longer by more than one other are built up anew.
void TileSolver::forget_the_lost(const PlanningProblem& problem) {
  const std::vector<std::int32_t> hops = count_hops(problem);
  std::vector<std::int32_t> around;
  for (std::size_t u = 0; u < hops.size(); ++u) {
    const std::int32_t before = std::exchange(map_.units[u].hops, hops[u]);
    if (map_.units[u].exponent == TileUnit::kAsleep || hops[u] <= 2 || (hops[u] != kNoWay && hops[u] < before + 2))
      continue;
    forget(static_cast<std::int32_t>(u));
    for_each_neighbour(map_, map_.units[u], [&](std::int32_t other) { around.push_back(other); });
  }
  each_once(around);
  for (const std::int32_t u : around) wake(u);
}

/// It tells all neighbours what it has, as if it had just got it.
void TileSolver::wake(std::int32_t number) {
  TileUnit& woken = unit(number);
  if (woken.exponent == TileUnit::kAsleep) return;
  woken.fresh = true;
  push(number, step_.place(number), kAllSides);
}

}  // namespace meander
