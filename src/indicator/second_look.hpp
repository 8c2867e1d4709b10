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
  /// Shortly beyond the last free place on the way from where the robot stands to within `arrive` of the goal; weak
  /// walls there are forgotten. No way leads through what is still in doubt at a place that was looked at before, so
  /// that this comes to an end. The goal itself: all of the way is free. None: no way is left, whatever is still
  /// unknown.
  std::optional<Vec2> next(SonarOccupancy& map, const Vec2& at, const Vec2& goal, double arrive);
  /// The map has become another: what was looked at before closes no way any more.
  void reopen() { first_ = looked_.size(); }
  int count() const { return static_cast<int>(looked_.size()); }
  /// Marks what is closed to the way to the place of the last look: what is still in doubt at the places before.
  const Grid<std::uint8_t>& closed_before(const ConfigurationSpace& map) { return close(map, count() - 1); }

 private:
  const Grid<std::uint8_t>& close(const ConfigurationSpace& map, int looks);
  std::vector<Cell> way_over(const ConfigurationSpace& space, const Vec2& at, const Vec2& goal, double arrive);
  std::optional<Vec2> look(SonarOccupancy& map, const std::vector<Cell>& way);

  GeodesicField field_;
  Grid<std::uint8_t> closed_;
  std::vector<Vec2> looked_;
  std::size_t first_ = 0;  ///< that counts
};

}  // namespace meander
