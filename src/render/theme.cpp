// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/theme.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

constexpr Color kOrange{230, 159, 0};
constexpr Color kSky{86, 180, 233};
constexpr Color kGreen{0, 158, 115};
constexpr Color kYellow{240, 228, 66};
constexpr Color kBlue{0, 114, 178};
constexpr Color kVermilion{213, 94, 0};
constexpr Color kPurple{204, 121, 167};

Theme light_theme() {
  Theme t;
  t.background = {243, 240, 233};
  t.floor = {255, 255, 255};
  t.grid = {238, 235, 228};
  t.bounds = {205, 199, 186};
  t.wall = {52, 60, 71};
  t.open_door = kVermilion;
  t.door = kVermilion;
  t.mover = kPurple;
  t.light = kYellow;
  t.place = {120, 128, 138};
  t.path = kBlue;
  t.sweep = faded(kSky, 80);
  t.cone = faded(kOrange, 64);
  t.echo = kOrange;
  t.start = kBlue;
  t.goal = kGreen;
  t.contact = kVermilion;
  t.robot = kBlue;
  t.robot_nose = {255, 255, 255};
  t.label = {60, 66, 75};
  t.muted = {134, 128, 114};
  return t;
}

Theme dark_theme() {
  Theme t = light_theme();
  t.background = {13, 17, 23};
  t.floor = {23, 29, 38};
  t.grid = {31, 39, 50};
  t.bounds = {56, 66, 80};
  t.wall = {198, 207, 218};
  t.place = {139, 150, 163};
  t.path = kSky;
  t.sweep = faded(kSky, 52);
  t.cone = faded(kOrange, 56);
  t.start = kSky;
  t.goal = {20, 190, 140};
  t.robot = kSky;
  t.robot_nose = {13, 17, 23};
  t.label = {226, 232, 240};
  t.muted = {128, 140, 155};
  return t;
}

std::uint8_t between(std::uint8_t from, std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
}

}  // namespace

const Theme& theme(Background background) {
  static const Theme light = light_theme();
  static const Theme dark = dark_theme();
  return background == Background::dark ? dark : light;
}

Color mixed(Color from, Color to, double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return {between(from.r, to.r, s), between(from.g, to.g, s), between(from.b, to.b, s), between(from.a, to.a, s)};
}

std::array<Color, 256> map_colors(const Theme& theme) {
  std::array<Color, 256> colors;
  for (std::size_t i = 0; i < colors.size(); ++i)
    colors[i] = mixed(theme.floor, theme.wall, static_cast<double>(i) / 255.0);
  return colors;
}

}  // namespace meander
