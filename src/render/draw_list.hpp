// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "geometry/shapes.hpp"

namespace meander {

struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Color&) const = default;
};

/// What is drawn, in world metres, back to front. Every backend (terminal, PNG, SVG) draws the same list.
struct DrawPolyline {
  std::vector<Vec2> points;
  bool closed = false;
  double width = 0;  ///< [m]; 0: a hairline
  Color color;
};
struct DrawArea {
  Polygon polygon;
  Color color;
};
struct DrawDisc {
  Disc disc;
  bool filled = true;
  Color color;
};
struct DrawText {
  Vec2 at{0, 0};  ///< lower left of the text
  std::string text;
  double height = 0.25;  ///< [m]
  Color color;
};
/// Coloured cells, e.g. a map or an activation landscape.
struct DrawCells {
  Pose2 origin;           ///< of the lower left corner
  double resolution = 1;  ///< [m]
  int width = 0, height = 0;
  std::vector<Color> colors;  ///< row-major, bottom row first
};
using DrawItem = std::variant<DrawPolyline, DrawArea, DrawDisc, DrawText, DrawCells>;

struct DrawList {
  Box view{{0, 0}, {1, 1}};
  Color background{255, 255, 255, 255};
  std::vector<DrawItem> items;
};

}  // namespace meander
