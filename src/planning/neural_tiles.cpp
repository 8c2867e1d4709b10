// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/neural_tiles.hpp"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "planning/neural_solution.hpp"
#include "planning/tile_queue.hpp"
#include "planning/tile_step.hpp"

namespace meander {
namespace {

constexpr std::uint8_t kAllSides = 0xf;

class TileSolver {
 public:
  TileSolver(const PlanningProblem& problem, const NeuralMapOptions& options, const TileKernel& kernel, TileMap map,
             const Work& work)
      : problem_(problem), options_(options), work_(work), map_(std::move(map)) {
    const double beta = options.steepness / (4 + 2 * std::numbers::sqrt2);
    const double root = std::sqrt(1 - options.steepness * options.steepness);
    const double omega = 1 + kShare * (1 - root) / (1 + root);
    taken_.assign(map_.tile.size(), 0);
    const int cores = tbb::info::default_concurrency();
    arena_.initialize(options.threads > 0 ? std::min(options.threads, cores) : cores);
    step_.emplace(TileStep{map_, kernel, curves_, beta, omega});
  }

  PlanningResult solve() {
    wake_targets();
    double threshold =
        options_.tolerance / 20;  // a direction is wrong where two neighbours differ by less than the error
    do {
      run(threshold);
      threshold /= 2;
    } while (verify() > 0.9 * options_.tolerance);
    return landscape();
  }

 private:
  static constexpr double kShare = 1;  ///< of the best over-relaxation of the open, cell by cell

  void wake_targets() {
    for (const Cell target : free_targets(problem_)) {
      const std::int32_t slot = map_.slot[static_cast<std::size_t>(map_.tile_of(target))];
      const int x = target.x % kTile, y = target.y % kTile;
      TileUnit& unit = map_.units[static_cast<std::size_t>(map_.unit_at(slot, x, y))];
      if (std::exchange(unit.exponent, 0) == TileUnit::kAsleep) ++awake_;
      unit.fresh = true;
      TileCurve& curve = curve_of(unit);
      curve.gain[y][x] = 0;
      curve.hold[y][x] = 1;
      TileCells& cells = map_.cells_of(slot);
      cells.cell[y][x] = 1;
      if (x == 0) cells.side[0][y] = 1;
      if (x == kTile - 1) cells.side[1][y] = 1;
      push(map_.unit_at(slot, x, y), 0, kAllSides);
    }
  }

  TileCurve& curve_of(TileUnit& unit) {
    if (unit.curve < 0) {
      unit.curve = static_cast<std::int32_t>(curves_.size());
      TileCurve& curve = curves_.emplace_back();
      for (int r = 0; r < kTile; ++r)
        for (int x = 0; x < kTile; ++x) curve.gain[r][x] = 1, curve.hold[r][x] = 1 - step_->omega;
    }
    return curves_[static_cast<std::size_t>(unit.curve)];
  }

  void push(std::int32_t number, std::int32_t key, std::uint8_t sides) {
    TileUnit& unit = map_.units[static_cast<std::size_t>(number)];
    unit.sides |= sides;
    if (std::max(key, queue_.turn()) < unit.key) unit.key = queue_.push(number, key);
  }

  /// In rounds, so that the order does not depend on who does it: all units of a bucket, those of every second tile of
  /// every second row together, because none of them sees another.
  void run(double threshold) {
    std::vector<std::int32_t> bucket, together;
    while (queue_.pop(bucket)) {
      work_.poll();
      for (int colour = 0; colour < 4; ++colour) {
        take_colour(bucket, colour, together);
        relax_together(together, threshold);
      }
      work_.report(std::min(1.0, static_cast<double>(awake_) / static_cast<double>(map_.units.size())), "neural map");
    }
  }

  /// Of units in the same tile only the first is taken, the others come with the next round.
  void take_colour(const std::vector<std::int32_t>& bucket, int colour, std::vector<std::int32_t>& together) {
    together.clear();
    ++round_;
    for (const std::int32_t number : bucket) {
      TileUnit& unit = map_.units[static_cast<std::size_t>(number)];
      const std::int32_t tile = map_.tile[static_cast<std::size_t>(unit.slot)];
      if ((tile % map_.across % 2 + tile / map_.across % 2 * 2) != colour) continue;
      if (unit.key != queue_.turn()) continue;  // it was taken up before
      unit.key = std::numeric_limits<std::int32_t>::max();
      if (std::exchange(taken_[static_cast<std::size_t>(unit.slot)], round_) == round_)
        push(number, queue_.turn(), 0);
      else
        together.push_back(number);
    }
  }

  void relax_together(const std::vector<std::int32_t>& units, double threshold) {
    if (outcomes_.size() < units.size()) outcomes_.resize(units.size());
    const auto relax = [&](std::size_t from, std::size_t to) {
      TileScratch scratch;
      for (std::size_t i = from; i < to; ++i) {
        outcomes_[i].count = 0;
        outcomes_[i].relaxations = 0;
        step_->relax(units[i], threshold, scratch, outcomes_[i]);
      }
    };
    constexpr std::size_t kWorthIt = 8;
    if (options_.threads == 1 || units.size() < kWorthIt)
      relax(0, units.size());
    else
      arena_.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, units.size(), kWorthIt / 2),
                          [&](const auto& range) { relax(range.begin(), range.end()); });
      });
    for (std::size_t i = 0; i < units.size(); ++i) hear(outcomes_[i]);
  }

  void hear(const TileOutcome& outcome) {
    relaxations_ += outcome.relaxations;
    for (int i = 0; i < outcome.count; ++i) {
      const TileNews& news = outcome.news[static_cast<std::size_t>(i)];
      TileUnit& unit = map_.units[static_cast<std::size_t>(news.unit)];
      if (unit.exponent == TileUnit::kAsleep) unit.exponent = news.exponent, ++awake_;
      if (news.steep) curve_of(unit);
      push(news.unit, news.key, news.sides);
    }
  }

  /// Takes up again what is not within the tolerance; returns the largest relative error.
  double verify() {
    residual_ = 0;
    queue_ = {};
    for (std::int32_t u = 0; u < static_cast<std::int32_t>(map_.units.size()); ++u) {
      if (u % 256 == 0) work_.poll();
      if (map_.units[static_cast<std::size_t>(u)].exponent == TileUnit::kAsleep) continue;
      const double error = step_->residual(u, scratch_);
      residual_ = std::max(residual_, error);
      if (error > 0.9 * options_.tolerance) push(u, step_->place(u), kAllSides);
    }
    return residual_;
  }

  PlanningResult landscape() {
    const Grid<std::uint8_t>& blocked = problem_.blocked;
    PlanningResult result{.value = Grid<double>(blocked.width(), blocked.height(), kNoValue, blocked.frame)};
    for (const TileUnit& unit : map_.units) {
      if (unit.slot % 64 == 0) work_.poll();
      if (unit.exponent == TileUnit::kAsleep) continue;
      const std::int32_t t = map_.tile[static_cast<std::size_t>(unit.slot)];
      const int left = (t % map_.across - 1) * kTile, low = (t / map_.across - 1) * kTile;
      const TileCells& cells = map_.cells_of(unit.slot);
      const double offset = unit.exponent * std::numbers::ln2;
      for (int y = 0; y < kTile; ++y) {
        if (unit.rows[static_cast<std::size_t>(y)] == 0) continue;
        double* row = &result.value[{left, low + y}];
        for (int x = 0; x < kTile; ++x)
          if ((unit.rows[static_cast<std::size_t>(y)] >> x & 1) == 0) {
            continue;
          } else if (cells.cell[y][x] > 0) {
            row[x] = natural_log(cells.cell[y][x]) + offset;
          } else {
            ++result.statistics.dead_units;
          }
      }
      result.statistics.cells += unit.size;
    }
    result.statistics.relaxations = relaxations_;
    result.statistics.residual = residual_;
    return result;
  }

  const PlanningProblem& problem_;
  const NeuralMapOptions& options_;
  const Work& work_;
  TileMap map_;
  std::vector<TileCurve> curves_;
  std::optional<TileStep> step_;
  TileQueue queue_;
  TileScratch scratch_{};
  std::vector<TileOutcome> outcomes_;
  std::vector<std::int32_t> taken_;  ///< the round in which each slot was last worked on
  std::int32_t round_ = 0;
  std::size_t awake_ = 0;
  tbb::task_arena arena_;
  std::int64_t relaxations_ = 0;
  double residual_ = 0;
};

}  // namespace

PlanningResult solve_tiles(const PlanningProblem& problem, const NeuralMapOptions& options, const Work& work,
                           const TileKernel* kernel) {
  TileMap map = tile_map(problem, work);
  constexpr std::size_t kLeastCells = 40;  // of a unit on average; below, tiles are mostly walls
  if (kernel == nullptr && map.cell_count < kLeastCells * map.units.size()) {
    const NeuralNet net = neural_net(problem, options, work);
    return landscape_of(net, solve_active_list(net, options, work), problem);
  }
  return TileSolver(problem, options, kernel != nullptr ? *kernel : *tile_kernels().back(), std::move(map), work)
      .solve();
}

}  // namespace meander
