// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "indicator/geodesic_field.hpp"
#include "indicator/sonar_occupancy.hpp"

namespace meander {

/// Before a goal is given up: is there any way to it, with unknown taken as passable, or when weak walls are doubted?
/// Then where does it leave what is known? That place is worth a look. One for one run.
class SecondLook {
 public:
  /// Shortly beyond the last free place on the way from the robot's cell, if there is a way; weak walls there are
  /// forgotten. A place
  /// that was looked at before and is still in doubt is closed for good, so that this comes to an end.
  std::optional<Vec2> next(SonarOccupancy& map, Cell from, Cell goal);
  int count() const { return static_cast<int>(looked_.size()); }

 private:
  std::optional<Vec2> along(SonarOccupancy& map, const ConfigurationSpace& space, Cell from, Cell goal);
  bool looked_at(const Vec2& place) const;
  void close(SonarOccupancy& map, Cell cell);

  GeodesicField field_;
  std::vector<Vec2> looked_;
};

}  // namespace meander
