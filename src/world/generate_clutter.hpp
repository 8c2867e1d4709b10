// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <optional>

#include "base/fields.hpp"
#include "base/work.hpp"
#include "world/world.hpp"

namespace meander {

/// Boxes and discs strewn over a walled room until they cover the share asked for. They may overlap, as things do that
/// stand together; the share counts no ground twice.
struct ClutterOptions {
  std::uint64_t seed = 1;
  double density = 0.10;
  double route = 0.4667;
  double disc_radius_min = 0.12;
  double disc_radius_max = 0.35;
  double box_side_min = 0.25;
  double box_side_max = 0.90;
  double boxes = 0.5;
  double width = 10;
  double height = 10;
  int draws = 400;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ClutterOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"seed", "", "the same seed, the same world"}, o.seed);
  visit(Field{"density", "", "share of the ground that objects cover", 0, 0.5}, o.density);
  visit(Field{"route", "m", "from start to goal leads a way that stays so far from everything", 0, 10}, o.route);
  visit(Field{"disc_radius_min", "m", "least radius of a disc", 0.02, 10}, o.disc_radius_min);
  visit(Field{"disc_radius_max", "m", "largest radius of a disc", 0.02, 10}, o.disc_radius_max);
  visit(Field{"box_side_min", "m", "least side of a box", 0.02, 10}, o.box_side_min);
  visit(Field{"box_side_max", "m", "largest side of a box", 0.02, 10}, o.box_side_max);
  visit(Field{"boxes", "", "share of boxes among the objects", 0, 1}, o.boxes);
  visit(Field{"width", "m", "of the room, along x", 3, 100}, o.width);
  visit(Field{"height", "m", "of the room, along y", 3, 100}, o.height);
  visit(Field{"draws", "", "tries to find such a world before giving up", 1, 1e6}, o.draws);
}

/// A world with a start at the lower left, looking at the place "goal" at the upper right. The route is sure: it was
/// found on a raster whose free cells keep half a cell more than `route`, by exact distances; a world with a route that
/// is only just as wide may be passed over. Nothing when no draw has one. Throws ArgumentError.
std::optional<World> generate_clutter(const ClutterOptions& options, const Work& work = {});

}  // namespace meander
