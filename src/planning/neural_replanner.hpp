// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>

#include "planning/neural_solution.hpp"
#include "planning/tile_solver.hpp"

namespace meander {

/// A cell that was blocked or freed.
struct CellEdit {
  Cell cell;
  bool blocked = true;
};

/// A neural map that follows edits of its map: after each the landscape is that of a solve from scratch, to the
/// tolerance, and only what changes is computed. On tiles where neural_map() would take tiles, else on the active list.
/// Difficulty and drag are solved anew with every edit: it may change the largest sum of weights, and so beta.
class NeuralReplanner {
 public:
  /// Solves the whole map. Throws ArgumentError like neural_map(), and for the other solvers and extents.
  explicit NeuralReplanner(PlanningProblem problem, const NeuralMapOptions& options = {}, const Work& work = {});

  /// Cells outside of the map are an ArgumentError; a blocked target is none until it is freed. When the work is
  /// cancelled the next edit() solves anew.
  void edit(std::span<const CellEdit> edits, const Work& work = {});

  PlanningResult landscape(const Work& work = {}) const {
    return tiles_ ? tiles_->landscape(problem_, work) : landscape_of(net_, solution_, problem_, work);
  }
  const PlanningProblem& problem() const { return problem_; }
  /// Of the last edit.
  std::int64_t last_relaxations() const { return tiles_ ? tiles_->relaxations() : solution_.relaxations; }

 private:
  void solve(const Work& work);
  void edit_tiles(std::span<const CellEdit> edits, const Work& work);
  void edit_net(std::span<const CellEdit> edits, const Work& work);
  std::vector<std::int32_t> relink_around(std::span<const CellEdit> edits);
  std::vector<std::int32_t> drop_unsupported(std::vector<std::int32_t> changed, const Work& work);

  PlanningProblem problem_;
  NeuralMapOptions options_;
  std::unique_ptr<TileSolver> tiles_;
  NeuralNet net_;  ///< this and the next without tiles only
  NeuralSolution solution_;
  bool settled_ = false;
};

}  // namespace meander
