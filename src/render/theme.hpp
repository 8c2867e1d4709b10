// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <utility>

#include "base/fields.hpp"
#include "render/draw_list.hpp"

namespace meander {

enum class Background { light, dark };
template <>
struct EnumNames<Background> {
  static constexpr std::pair<Background, const char*> entries[] = {{Background::light, "light"},
                                                                   {Background::dark, "dark"}};
};

/// Colours by meaning. The hues are those of Okabe and Ito (2008), "Color Universal Design": they stay apart for people
/// with any common form of colour blindness, and differ in lightness too.
struct Theme {
  Color background;  ///< around the world
  Color floor, grid, bounds;
  Color wall, open_door, door, mover, light, place;
  Color path, sweep;  ///< centre line of a way, and the width that the body swept
  Color cone, echo;   ///< sonar cone, and the arc at which it heard something
  Color start, goal, contact;
  Color robot, robot_nose;
  Color label, muted;  ///< names, and what matters less: scale bar, caption
};

const Theme& theme(Background background);

/// The colour with its opacity replaced.
constexpr Color faded(Color color, std::uint8_t alpha) { return {color.r, color.g, color.b, alpha}; }

/// The colour `share` of the way from `from` to `to`, opacity included.
Color mixed(Color from, Color to, double share);

/// One colour per value of a byte map: 0 floor ... 255 wall.
std::array<Color, 256> map_colors(const Theme& theme);

}  // namespace meander
