// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/landscape.hpp"
#include "planning/neural_map_options.hpp"
#include "planning/round_team.hpp"
#include "planning/tile_queue.hpp"
#include "planning/tile_step.hpp"

namespace meander {

/// The equilibrium tile by tile: units that have something new around them are relaxed in the order of what they have
/// to tell, in rounds whose order does not depend on who does the work.
class TileSolver {
 public:
  TileSolver(TileMap map, const NeuralMapOptions& options, const TileKernel& kernel);
  TileSolver(const TileSolver&) = delete;
  TileSolver& operator=(const TileSolver&) = delete;

  /// From rest.
  void solve(const PlanningProblem& problem, const Work& work);
  /// To be called once before the first follow().
  void expect_edits(const PlanningProblem& problem);
  /// From the equilibrium of the map as it was before cells of these tiles (TileMap::tile_of) were blocked or freed.
  void follow(const PlanningProblem& problem, std::vector<std::int32_t> tiles, const Work& work);

  PlanningResult landscape(const PlanningProblem& problem, const Work& work) const;
  std::int32_t tile_of(Cell cell) const { return map_.tile_of(cell); }
  std::int64_t relaxations() const { return relaxations_; }  ///< of the last solve() or follow()

 private:
  TileUnit& unit(std::int32_t number) { return map_.units[static_cast<std::size_t>(number)]; }
  std::int32_t unit_of(Cell cell) const;
  void plant(Cell target);
  TileCurve& curve_of(TileUnit& unit);
  void push(std::int32_t number, std::int32_t key, std::uint8_t sides);
  void settle(const Work& work);
  void run(double threshold, RoundTeam* team, const Work& work);
  void take_those_in_turn(const std::vector<std::int32_t>& units, std::vector<std::int32_t>& together);
  void relax_together(const std::vector<std::int32_t>& units, double threshold, RoundTeam* team);
  void hear(const TileOutcome& outcome);
  std::vector<std::int32_t> touched();
  double verify(const Work& work);

  void recut_tiles(const PlanningProblem& problem, const std::vector<std::int32_t>& tiles);
  void restore_curves(const PlanningProblem& problem, const std::vector<std::int32_t>& tiles);
  std::vector<std::int32_t> count_hops(const PlanningProblem& problem) const;
  void forget(std::int32_t number);
  void forget_the_lost(const PlanningProblem& problem);
  void wake(std::int32_t number);

  NeuralMapOptions options_;
  TileMap map_;
  std::vector<TileCurve> curves_;
  TileStep step_;
  TileQueue queue_;
  TileScratch scratch_{};
  std::vector<TileOutcome> outcomes_;
  std::vector<std::int32_t> taken_;  ///< the round in which each slot was last worked on
  std::int32_t round_ = 0;
  std::vector<std::int32_t> touched_;
  std::size_t awake_ = 0;
  int threads_ = 1;
  std::int64_t relaxations_ = 0;
  double residual_ = 0;
};

}  // namespace meander
