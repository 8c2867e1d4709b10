// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "topology/cell_pool.hpp"
#include "topology/error_heap.hpp"
#include "topology/place_index.hpp"
#include "topology/senses.hpp"

namespace meander::topology {

/// What is shown to a net: where, and a row of senses (stride values).
struct Situation {
  Vec2 position{0, 0};
  const float* senses = nullptr;
};

/// The cell that won, and how far it was.
struct Match {
  int cell = -1;
  double distance = 0;
};

/// A growing, shrinking net of cells ([Z] sections 3-2 and 3-3; after Fritzke's growing cell structures). Spatial nets
/// know places and look only at cells that can be near enough: the effort of a presentation does not depend on the
/// number of cells. The others compare senses alone, with every cell.
class GrowingNet {
 public:
  /// `position_scale` [m]; 0: a net without places.
  GrowingNet(const NetOptions& options, const SenseMetric& metric, double position_scale);

  /// One adaptation step; gives the cell that stands for the situation now.
  Match present(const Situation& situation, std::int64_t sample);
  /// The nearest cell within insert_distance, ties to the smaller number. Changes nothing. [Z] eq. (1)
  std::optional<Match> nearest(const Situation& situation) const;
  /// A new cell at the situation, linked to `neighbour` unless that is -1.
  int insert(const Situation& situation, std::int64_t sample, int neighbour);
  void remove(int cell);
  /// What comes next does not follow from what was shown last: no link to the last winner.
  void break_off() { winner_ = -1; }

  const CellPool& cells() const { return cells_; }
  CellPool& cells() { return cells_; }
  bool spatial() const { return per_position_ > 0; }
  const NetOptions& options() const { return options_; }
  const SenseMetric& metric() const { return metric_; }
  /// Calls visit(cell) for every cell whose place may be within `reach` [m].
  template <class Visit>
  void around(const Vec2& at, double reach, Visit visit) const {
    index_.around(at, reach, visit);
  }
  int winner() const { return winner_; }
  /// The present share by which a winner moves: small when the net fits what is shown.
  double rate() const { return rate_; }
  double error(int cell) const { return errors_.error(cell); }

 private:
  friend struct NetState;
  double squared(int cell, const Situation& situation, double limit) const;
  void adapt(const Match& match, const Situation& situation);
  void pull(int cell, const Situation& situation, double share);
  void miss();
  void change_winner(int to);
  void fade_links(int cell, int kept);
  void drop_small_component(int cell, int winner);
  void insert_where_worst(std::int64_t sample);

  NetOptions options_;
  SenseMetric metric_;
  double per_position_ = 0;  ///< 1 / scale^2; 0: a net without places
  CellPool cells_;
  PlaceIndex index_;
  ErrorHeap errors_;
  int winner_ = -1;
  double rate_, neighbour_rate_;  ///< eps_o, eps_n
  std::int64_t misses_ = 0;
  std::vector<int> component_;  ///< scratch
  std::vector<float> middle_;   ///< scratch
};

}  // namespace meander::topology
