// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "indicator/sonar_occupancy.hpp"
#include "planning/clearance.hpp"
#include "planning/planning_map.hpp"

namespace meander {

/// What the sonars hear and a map does not show. Sees observations and the map, in one frame, and nothing else.
class UnmappedObstacles {
 public:
  /// What is heard nearer than `tolerance` [m] to something solid in the map is taken to be that.
  UnmappedObstacles(const Platform& platform, std::shared_ptr<const PlanningMap> map, double tolerance);

  void listen(const Observation& observation) { heard_.update(observation); }
  /// Looks through what was heard so far; nothing is done when nothing has changed since the last time.
  const std::vector<Vec2>& points();
  /// Is one of the points of the last look nearer than `distance` to the straight way? [m]
  bool beside(const Vec2& from, const Vec2& to, double distance) const;
  /// Nothing has been heard.
  void forget();

 private:
  Platform platform_;
  std::shared_ptr<const PlanningMap> map_;
  double tolerance_;
  SonarOccupancy heard_;
  std::optional<Clearance> clearance_;  ///< of the map
  std::uint64_t map_version_ = 0, heard_version_ = 0;
  int frames_ = 0;
  std::vector<Vec2> points_;  ///< centres of cells, in the map's frame [m]
};

}  // namespace meander
