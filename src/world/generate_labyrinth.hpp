// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "grid/labyrinth.hpp"
#include "world/world.hpp"

namespace meander {

/// The walls of a labyrinth.
struct LabyrinthWalls {
  double corridor = 1;
  double jitter = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LabyrinthWalls>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"corridor", "m", "side of a cell, width of the corridors between thin walls", 0.4, 10}, o.corridor);
  visit(Field{"jitter", "", "corners of inner walls are moved along x and y by up to so many corridor widths", 0, 0.25},
        o.jitter);
}

/// A world with the walls of a labyrinth, cell (0, 0) at the lower left; the start is in that cell, the place "goal" in
/// the last one. `seed` draws the jitter. Throws ArgumentError when a number is out of range.
World labyrinth_world(const Labyrinth& labyrinth, const LabyrinthWalls& walls, std::uint64_t seed);

}  // namespace meander
