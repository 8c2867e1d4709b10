// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/fields.hpp"
#include "grid/grid.hpp"

namespace meander {

/// How a labyrinth grows: always on from the newest cell (long corridors), from any cell (many crossings), or either.
enum class LabyrinthKind { backtracker, prim, mixed };
template <>
struct EnumNames<LabyrinthKind> {
  static constexpr std::pair<LabyrinthKind, const char*> entries[] = {
      {LabyrinthKind::backtracker, "backtracker"}, {LabyrinthKind::prim, "prim"}, {LabyrinthKind::mixed, "mixed"}};
};

struct LabyrinthPlan {
  std::uint64_t seed = 1;
  LabyrinthKind kind = LabyrinthKind::mixed;
  int columns = 10;
  int rows = 10;
  double loops = 0;
  int rooms = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LabyrinthPlan>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"seed", "", "the same seed, the same labyrinth"}, o.seed);
  visit(Field{"kind", "", "long corridors, many crossings, or both"}, o.kind);
  visit(Field{"columns", "", "cells along x", 1, 200}, o.columns);
  visit(Field{"rows", "", "cells along y", 1, 200}, o.rows);
  visit(Field{"loops", "", "each inner wall of the tree is taken away with this probability", 0, 1}, o.loops);
  visit(Field{"rooms", "", "so many times the inner walls of 2 to 4 by 2 to 4 cells are taken away", 0, 1000}, o.rooms);
}

/// Sides of a cell, counter-clockwise from east: side k looks into direction k * 90 degrees.
inline constexpr int kSides = 4;
constexpr int opposite(int side) { return (side + 2) % kSides; }
constexpr Cell beside(Cell cell, int side) {
  constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
  return {cell.x + dx[side], cell.y + dy[side]};
}

/// Cells with or without walls between them; walled all around.
class Labyrinth {
 public:
  /// All walls stand. Throws ArgumentError unless both numbers are at least 1.
  Labyrinth(int columns, int rows);

  int columns() const { return open_.width(); }
  int rows() const { return open_.height(); }
  bool contains(Cell cell) const { return open_.contains(cell); }
  bool open(Cell cell, int side) const { return (open_[cell] >> side & 1) != 0; }
  int ways(Cell cell) const;  ///< open sides
  /// Takes the wall away or puts it there. Throws ArgumentError for walls around the labyrinth.
  void set_open(Cell cell, int side, bool open);
  /// Cells on the shortest way from `from`, -1 where none leads; `from` itself is 0.
  Grid<int> steps_from(Cell from) const;
  bool operator==(const Labyrinth&) const = default;

 private:
  Grid<std::uint8_t> open_;  ///< a bit per side
};

/// A labyrinth from a seed; every cell can be reached. Throws ArgumentError when a number is out of range.
Labyrinth make_labyrinth(const LabyrinthPlan& plan);

}  // namespace meander
