// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>

#include "mapping/local_map.hpp"
#include "polar/polar_options.hpp"
#include "robot/contracts.hpp"

namespace meander {

struct MapObstacleOptions {
  double occupied = 0.5;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapObstacleOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"occupied", "", "cells of at least this probability are obstacles", 0.05, 0.95}, o.occupied);
}

/// The centres of the occupied cells of the local map, in the odometry frame, no farther than `reach` from a point.
void occupied_cells(const LocalMap& map, double occupied, const Vec2& from, double reach, std::vector<Vec2>& points);

/// The polar navigator of [LM99] with the local map of [CN] in place of its memory of single readings: what it maps are
/// the occupied cells. Throws ArgumentError.
Navigator polar_on_map(const Platform& platform, std::shared_ptr<LocalMap> map, const PolarOptions& polar = {},
                       const MapObstacleOptions& options = {});

struct MapSafetyOptions {
  double margin = 0.03;
  MapObstacleOptions obstacles;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapSafetyOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"margin", "m", "no command may lead the hull nearer to an occupied cell than this", 0, 1}, o.margin);
  fields(o.obstacles, visit);
}

/// [CN] section 1: the local map as a safety device. Whatever the navigator commands, the robot drives no faster than
/// lets it stop, after one cycle and braking, before its hull is nearer to an occupied cell than the margin; turning on
/// the spot and getting away from what is near stay allowed. Throws ArgumentError.
Navigator with_map_safety(Navigator navigator, const Platform& platform, std::shared_ptr<LocalMap> map,
                          const MapSafetyOptions& options = {});

}  // namespace meander
