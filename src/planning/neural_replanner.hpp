// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/neural_solution.hpp"

namespace meander {

/// A cell that was blocked or freed.
struct CellEdit {
  Cell cell;
  bool blocked = true;
};

/// A neural map that follows edits of its map: after each the landscape is that of a solve from scratch, to the
/// tolerance, and only what changes is computed.
class NeuralReplanner {
 public:
  /// Solves the whole map with the active list. Throws ArgumentError like neural_map().
  explicit NeuralReplanner(PlanningProblem problem, const NeuralMapOptions& options = {}, const Work& work = {});

  /// Cells outside of the map are an ArgumentError; a blocked target is none until it is freed. When the work is
  /// cancelled the next edit() solves anew.
  void edit(std::span<const CellEdit> edits, const Work& work = {});

  PlanningResult landscape() const { return landscape_of(net_, solution_, problem_); }
  const PlanningProblem& problem() const { return problem_; }
  std::int64_t last_relaxations() const { return solution_.relaxations; }  ///< of the last edit

 private:
  void solve(const Work& work);
  std::vector<std::int32_t> relink_around(std::span<const CellEdit> edits);
  std::vector<std::int32_t> drop_unsupported(std::vector<std::int32_t> changed, const Work& work);

  PlanningProblem problem_;
  NeuralMapOptions options_;
  NeuralNet net_;
  NeuralSolution solution_;
  bool settled_ = false;
};

}  // namespace meander
