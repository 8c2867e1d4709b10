// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "planning/problem.hpp"

namespace meander {

/// What is known of a place: what stands there, and how hard it is to go. A planner or guide sees this and nothing
/// else.
struct PlanningMap {
  Grid<std::uint8_t> solid;
  Grid<float> difficulty{};      ///< empty: 1 everywhere
  Grid<Eigen::Vector2f> drag{};  ///< empty: none; see PlanningProblem
  std::uint64_t version = 0;     ///< counts the edits
};

/// What becomes of cells of which nobody knows what stands there.
enum class UnknownCells { blocked, free, costly };
template <>
struct EnumNames<UnknownCells> {
  static constexpr std::pair<UnknownCells, const char*> entries[] = {
      {UnknownCells::blocked, "blocked"}, {UnknownCells::free, "free"}, {UnknownCells::costly, "costly"}};
};

struct OccupancyOptions {
  double occupied = 0.65;
  double vacant = 0.35;
  UnknownCells unknown = UnknownCells::blocked;
  double unknown_cost = 4;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, OccupancyOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"occupied", "", "cells of at least this probability are solid", 0, 1}, o.occupied);
  visit(Field{"vacant", "", "cells of at most this probability are free; between the two they are unknown", 0, 1},
        o.vacant);
  visit(Field{"unknown", "", "what becomes of unknown cells"}, o.unknown);
  visit(Field{"unknown_cost", "", "difficulty of unknown cells where they are costly", 1, 1000}, o.unknown_cost);
}

/// A map of probabilities that something stands there. What is not a number from 0 to 1 is unknown.
PlanningMap map_from_occupancy(const Grid<float>& probability, const OccupancyOptions& options = {});

/// Blocks or frees the cells whose centres lie in the box.
void set_solid(PlanningMap& map, const Box& box, bool solid);
/// Gives the same cells a difficulty, or a drag; a map that has none gets 1, or no drag, everywhere else. Out of range:
/// an ArgumentError, and the map stays as it was.
void set_difficulty(PlanningMap& map, const Box& box, double difficulty);
void set_drag(PlanningMap& map, const Box& box, const Vec2& drag);

/// Where a robot of a radius [m] wants to go [m].
struct PlanningTask {
  std::optional<Vec2> start{};
  std::vector<Vec2> targets;
  double robot_radius = 0;
  Corners corners = Corners::keep;
  Lattice lattice = Lattice::rectangular;
};

/// The task on the map, in cells. For hexagons the map is sampled anew, so that every step keeps the robot clear of
/// what is solid in the map of squares. Throws ArgumentError.
PlanningProblem problem_on(const PlanningMap& map, const PlanningTask& task, const Work& work = {});

/// A point of the grid, counted in cells, in metres.
Vec2 in_metres(const GridFrame& frame, const Vec2& cells);

}  // namespace meander
