// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "base/fields.hpp"
#include "render/draw_list.hpp"
#include "render/theme.hpp"
#include "world/world.hpp"

namespace meander {

struct WorldLook {
  Background background = Background::light;
  bool names = true;
  bool grid = true;
  bool scale = true;
  bool movers = true;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WorldLook>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"background", "", "light or dark"}, o.background);
  visit(Field{"names", "", "write the names of places"}, o.names);
  visit(Field{"grid", "", "draw grid lines on the floor"}, o.grid);
  visit(Field{"scale", "", "draw a scale bar and the title below the world"}, o.scale);
  visit(Field{"movers", "", "draw movers where they start, with their ways"}, o.movers);
}

/// The picture of a world: floor, obstacles, doors, movers, lights, places, start, scale bar.
DrawList draw_world(const World& world, const WorldLook& look = {});

/// A list that shows the floor of `bounds` alone, with a margin, grid and scale bar as the look asks: the base of every
/// picture in the plane. Throws ArgumentError when the bounds are not finite.
DrawList draw_floor(const Box& bounds, const std::string& caption, const WorldLook& look = {});

}  // namespace meander
