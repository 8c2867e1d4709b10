// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <vector>

#include "indicator/configuration_space.hpp"
#include "indicator/dstar_lite.hpp"

namespace meander {

/// The shortest way to a goal over a map that is being made, with all taken as free of which nothing is known, kept up
/// by D* Lite.
class FreeSpaceWay {
 public:
  /// The cells from `start` to the goal, both included; empty: no way leads there.
  const std::vector<Cell>& plan(const ConfigurationSpace& space, Cell start, Cell goal);
  /// Of the way that was planned last [m]; infinite: there was none.
  double length() const { return planner_ ? planner_->length() * resolution_ : 0; }
  /// Cells have moved.
  void forget() { planner_.reset(); }

 private:
  void follow(const ConfigurationSpace& space);

  std::optional<DStarLite> planner_;
  Cell goal_;
  std::uint64_t version_ = 0;  ///< of the map that the planner knows
  double resolution_ = 1;      ///< [m]
};

}  // namespace meander
