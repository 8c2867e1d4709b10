// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "indicator/geodesic_field.hpp"

namespace meander {

/// How far it is to the goal at least, for all that is known: unknown cells may be gone through, walls not. Looks at
/// squares of cells, so that it is found anew at each decision.
class GoalWays {
 public:
  /// Follows what has changed. One for one map and one goal.
  void update(const ConfigurationSpace& map, const Vec2& goal);
  /// No way from here to the goal is shorter [m]; infinite: none leads there.
  double least(const Vec2& from) const;

 private:
  void look(const ConfigurationSpace& map, Cell square);

  std::optional<ConfigurationSpace> squares_;
  std::uint64_t version_ = 0, squares_version_ = 0;  ///< of the map, of its squares
  Vec2 goal_{0, 0};
  GeodesicField field_;
};

}  // namespace meander
