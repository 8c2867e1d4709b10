// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/tile_solver.hpp"

#include <tbb/info.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "planning/extended.hpp"

namespace meander {
namespace {

constexpr std::uint8_t kAllSides = 0xf;
constexpr double kEnough = 0.25;  ///< of the tolerance, so that two solutions differ by no more than that

/// Of the best over-relaxation of the open, cell by cell.
double over_relaxation(double steepness) {
  const double root = std::sqrt(1 - steepness * steepness);
  return 1 + (1 - root) / (1 + root);
}

}  // namespace

TileSolver::TileSolver(TileMap map, const NeuralMapOptions& options, const TileKernel& kernel)
    : options_(options),
      map_(std::move(map)),
      step_{map_,
            kernel,
            curves_,
            options.steepness / (4 + 2 * std::numbers::sqrt2),
            over_relaxation(options.steepness),
            0.2 * std::sqrt(options.tolerance)},
      taken_(map_.tile.size(), 0) {
  const int cores = tbb::info::default_concurrency();
  threads_ = options.threads > 0 ? std::min(options.threads, cores) : cores;
}

void TileSolver::solve(const PlanningProblem& problem, const Work& work) {
  for (const Cell target : free_targets(problem)) {
    plant(target);
    push(unit_of(target), 0, kAllSides);
  }
  settle(work);
}

void TileSolver::settle(const Work& work) {
  std::optional<RoundTeam> team;
  if (threads_ > 1) team.emplace(threads_ - 1);
  double threshold = options_.tolerance / 20, worst = 0;  // a direction is wrong where neighbours differ by less
  do {
    run(threshold, team ? &*team : nullptr, work);
    threshold /= 2;
    worst = verify(work);
  } while (worst > kEnough * options_.tolerance);
  residual_ = std::max(residual_, worst);
}

std::int32_t TileSolver::unit_of(Cell cell) const {
  return map_.unit_at(map_.slot[static_cast<std::size_t>(map_.tile_of(cell))], cell.x % kTile, cell.y % kTile);
}

/// Activation 1 for ever.
void TileSolver::plant(Cell target) {
  const int x = target.x % kTile, y = target.y % kTile;
  TileUnit& home = unit(unit_of(target));
  if (home.exponent == TileUnit::kAsleep) home.exponent = 0, ++awake_;
  step_.rebase(home);
  home.fresh = true;
  TileCurve& curve = curve_of(home);
  curve.gain[y][x] = 0;
  curve.hold[y][x] = 1;
  TileCells& cells = map_.cells_of(home.slot);
  cells.cell[y][x] = 1;
  if (x == 0) cells.side[0][y] = 1;
  if (x == kTile - 1) cells.side[1][y] = 1;
}

TileCurve& TileSolver::curve_of(TileUnit& unit) {
  if (unit.curve < 0) {
    unit.curve = static_cast<std::int32_t>(curves_.size());
    TileCurve& curve = curves_.emplace_back();
    for (int r = 0; r < kTile; ++r)
      for (int x = 0; x < kTile; ++x) curve.gain[r][x] = 1, curve.hold[r][x] = 1 - step_.omega;
  }
  return curves_[static_cast<std::size_t>(unit.curve)];
}

void TileSolver::push(std::int32_t number, std::int32_t key, std::uint8_t sides) {
  TileUnit& pushed = unit(number);
  pushed.sides |= sides;
  if (std::max(key, queue_.turn()) < pushed.key) pushed.key = queue_.push(number, key);
}

/// In rounds, so that the order does not depend on who does it: all units of a bucket, those of every second tile of
/// every second row together, because none of them sees another.
void TileSolver::run(double threshold, RoundTeam* team, const Work& work) {
  std::vector<std::int32_t> bucket, together;
  std::array<std::vector<std::int32_t>, 4> of_colour;
  while (queue_.pop(bucket)) {
    for (std::vector<std::int32_t>& units : of_colour) units.clear();
    for (const std::int32_t number : bucket) of_colour[unit(number).colour].push_back(number);
    for (const std::vector<std::int32_t>& units : of_colour) {
      work.poll();
      take_those_in_turn(units, together);
      relax_together(together, threshold, team);
    }
    work.report(std::min(1.0, static_cast<double>(awake_) / static_cast<double>(map_.units.size())), "neural map");
  }
}

/// Of units in the same tile only the first is taken, the others come with the next round.
void TileSolver::take_those_in_turn(const std::vector<std::int32_t>& units, std::vector<std::int32_t>& together) {
  together.clear();
  ++round_;
  for (const std::int32_t number : units) {
    TileUnit& unit = map_.units[static_cast<std::size_t>(number)];
    if (unit.key != queue_.turn()) continue;  // it was taken up before
    unit.key = std::numeric_limits<std::int32_t>::max();
    if (std::exchange(taken_[static_cast<std::size_t>(unit.slot)], round_) == round_)
      push(number, queue_.turn(), 0);
    else
      together.push_back(number);
  }
}

void TileSolver::relax_together(const std::vector<std::int32_t>& units, double threshold, RoundTeam* team) {
  if (outcomes_.size() < units.size()) outcomes_.resize(units.size());
  const auto relax = [&](std::size_t from, std::size_t to) {
    TileScratch scratch;
    for (std::size_t i = from; i < to; ++i) {
      outcomes_[i].count = 0;
      outcomes_[i].relaxations = 0;
      step_.relax(units[i], threshold, scratch, outcomes_[i]);
    }
  };
  constexpr std::size_t kWorthIt = 8, kGrain = 4;
  if (team != nullptr && units.size() >= kWorthIt)
    team->run(units.size(), kGrain, relax);
  else
    relax(0, units.size());
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (!std::exchange(unit(units[i]).touched, true)) touched_.push_back(units[i]);
    hear(outcomes_[i]);
  }
}

void TileSolver::hear(const TileOutcome& outcome) {
  relaxations_ += outcome.relaxations;
  for (int i = 0; i < outcome.count; ++i) {
    const TileNews& news = outcome.news[static_cast<std::size_t>(i)];
    TileUnit& unit = map_.units[static_cast<std::size_t>(news.unit)];
    if (unit.exponent == TileUnit::kAsleep) unit.exponent = news.exponent, ++awake_;
    if (news.steep) curve_of(unit);
    push(news.unit, news.key, news.sides);
  }
}

/// The units that were relaxed since it was asked last, and those that have heard of it.
std::vector<std::int32_t> TileSolver::touched() {
  std::vector<std::int32_t> all = std::exchange(touched_, {});
  const std::size_t relaxed = all.size();
  for (std::size_t i = 0; i < relaxed; ++i) {
    const TileUnit& one = unit(all[i]);
    for_each_neighbour(map_, one, [&](std::int32_t u) {
      if (!std::exchange(unit(u).touched, true)) all.push_back(u);
    });
  }
  for (const std::int32_t u : all) unit(u).touched = false;
  std::sort(all.begin(), all.end());
  return all;
}

/// Takes up again what is not within the tolerance; returns the largest relative error.
double TileSolver::verify(const Work& work) {
  double worst = 0;
  queue_ = {};
  std::size_t count = 0;
  for (const std::int32_t u : touched()) {
    if (++count % 256 == 0) work.poll();
    if (unit(u).exponent == TileUnit::kAsleep) continue;
    const double error = step_.residual(u, scratch_);
    worst = std::max(worst, error);
    if (error > kEnough * options_.tolerance) push(u, step_.place(u), kAllSides);
  }
  return worst;
}

PlanningResult TileSolver::landscape(const PlanningProblem& problem, const Work& work) const {
  const Grid<std::uint8_t>& blocked = problem.blocked;
  PlanningResult result{.value = Grid<double>(blocked.width(), blocked.height(), kNoValue, blocked.frame)};
  for (const TileUnit& unit : map_.units) {
    if (unit.slot % 64 == 0) work.poll();
    if (unit.exponent == TileUnit::kAsleep) continue;
    const std::int32_t t = map_.tile[static_cast<std::size_t>(unit.slot)];
    const int left = (t % map_.across - 1) * kTile, low = (t / map_.across - 1) * kTile;
    const TileCells& cells = map_.cells_of(unit.slot);
    const double offset = unit.exponent * std::numbers::ln2;
    for (int y = 0; y < kTile; ++y) {
      if (unit.rows[static_cast<std::size_t>(y)] == 0) continue;
      double* row = &result.value[{left, low + y}];
      for (int x = 0; x < kTile; ++x)
        if ((unit.rows[static_cast<std::size_t>(y)] >> x & 1) != 0 && cells.cell[y][x] > 0)
          row[x] = natural_log(cells.cell[y][x]) + offset;
    }
    result.statistics.cells += unit.size;
  }
  result.statistics.dead_units = dead_units(problem, result.value, work);
  result.statistics.relaxations = relaxations_;
  result.statistics.residual = residual_;
  result.statistics.solver = to_string(NeuralSolver::tiles);
  return result;
}

}  // namespace meander
