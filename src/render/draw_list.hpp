// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/shapes.hpp"

namespace meander {

struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Color&) const = default;
};

/// What an item stands for, in painting order: later marks cover earlier ones, whatever order they were added in. A
/// terminal without colours draws each mark by its own character.
enum class Mark : std::uint8_t {
  ground,
  grid,
  cell,
  bar,
  sweep,
  cone,
  place,
  light,
  open_door,
  wall,
  door,
  mover,
  path,
  curve,
  echo,
  start,
  goal,
  contact,
  label,
  robot,
};
inline constexpr int kMarks = 20;

/// [m]; beyond it a double no longer tells millimetres apart.
inline constexpr double kDrawnReach = 1e12;

/// What is drawn, in world metres. Every backend (terminal, PNG, SVG) draws the same list. Items with a number that is
/// not finite or beyond kDrawnReach are left out.
struct DrawPolyline {
  std::vector<Vec2> points;
  bool closed = false;
  double width = 0;  ///< [m]; 0: a hairline
  Color color;
  Mark mark = Mark::wall;
};
struct DrawArea {
  Polygon polygon;
  Color color;
  Mark mark = Mark::wall;
};
struct DrawDisc {
  Disc disc;
  Color color;
  Mark mark = Mark::wall;
  double line = 0;  ///< width of the circle line [m]; 0: filled
};
enum class Align { left, center, right };
struct DrawText {
  Vec2 at{0, 0};  ///< on the base line: its left end, middle or right end
  std::string text;
  double height = 0.25;  ///< of a capital letter [m]
  Color color;
  Color halo{0, 0, 0, 0};  ///< thin rim that keeps the text readable on anything
  Align align = Align::left;
  Mark mark = Mark::label;
};
/// Coloured cells, e.g. a map or an activation landscape.
struct DrawCells {
  Pose2 origin;           ///< of the lower left corner
  double resolution = 1;  ///< [m]
  int width = 0, height = 0;
  std::vector<Color> colors;  ///< row-major, bottom row first
  std::vector<Mark> marks;    ///< the same shape, or empty: Mark::cell everywhere
};
/// Something round, with an arrow that shows where it heads. Where it is too small for that, a terminal shows the
/// heading by a character.
struct DrawBody {
  Disc disc;
  std::optional<double> heading;
  Color color;
  Color nose;
  Mark mark = Mark::robot;
};
using DrawItem = std::variant<DrawPolyline, DrawArea, DrawDisc, DrawText, DrawCells, DrawBody>;

struct DrawList {
  Box view{{0, 0}, {1, 1}};
  Color background{255, 255, 255, 255};
  std::vector<DrawItem> items;
};

/// Cells count as Mark::cell.
Mark mark_of(const DrawItem& item);

/// The items in painting order: by mark, and within a mark in the order they were added.
std::vector<const DrawItem*> painting_order(const DrawList& list);

/// Can the item be drawn at all? Numbers finite, sizes matching.
bool drawable(const DrawItem& item);

/// What a body is made of: a disc, its rim, and the arrow.
std::vector<DrawItem> parts(const DrawBody& body);

/// Valid UTF-8 without control characters: names come from files and must neither break XML nor steer a terminal.
/// Offending bytes become U+FFFD.
std::string printable(const std::string& text);

}  // namespace meander
