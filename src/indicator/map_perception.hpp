// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "base/fields.hpp"
#include "indicator/goal_ways.hpp"

namespace meander {

struct MapPerceptionOptions {
  double ball = 1.25;
  double shell = 0.12;
  double piece = 0.9;
  int cells = 3;
  double window = 4;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapPerceptionOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"ball", "m", "what is so near by a free way belongs to an indicator: 1.25 corridor widths", 0.1, 100},
        o.ball);
  visit(Field{"shell", "m", "thickness of the ball's shell, in which ports are sought", 0.01, 10}, o.shell);
  visit(Field{"piece", "m", "a wider piece of the shell is cut", 0.1, 100}, o.piece);
  visit(Field{"cells", "", "least number of cells of a port", 1, 1000}, o.cells);
  visit(Field{"window", "m", "so far around an indicator is looked for what lies behind a port", 0.5, 100}, o.window);
}

/// A way out of an indicator, as the map tells it now.
struct MapPort {
  Vec2 position{0, 0};   ///< in the map's frame [m]
  double direction = 0;  ///< from the indicator [rad]
  double way = 0;        ///< length of the way there [m]
  double bound = 0;      ///< no way from the indicator over this port to the goal is shorter, for all that is known [m]
};

/// Reads the ports of indicators off a map. [DG+] The paper takes them from the reactive system's motion intervals at
/// the indicator, which change as the robot moves about it ([DG] Figure 3); the map keeps still. What it tells depends
/// on the map alone, so that nothing goes stale; balls are kept as long as the map has not changed there. One for one
/// map.
class MapPerception {
 public:
  explicit MapPerception(const MapPerceptionOptions& options = {});

  /// The ports of indicator `which`: pieces of its ball's shell that no ball covers, behind which something is unknown
  /// from which a way may lead to the goal, or the goal lies (a passage that is seen to be blind has none), and such
  /// pieces of the frontier inside its own ball. A cell belongs to the first indicator whose ball covers it.
  std::vector<MapPort> ports(const ConfigurationSpace& map, std::span<const Vec2> indicators, std::size_t which,
                             const Vec2& goal);

 private:
  struct Behind {
    bool worth = false;   ///< a frontier, the goal, or more than the window shows
    double least_on = 0;  ///< from the piece to the goal at least [m]
  };
  /// The cells of an indicator's ball.
  struct Ball {
    Vec2 place{0, 0};
    std::uint64_t version = 0;  ///< of the map
    std::vector<Cell> cells;
  };
  const std::vector<Cell>& ball(const ConfigurationSpace& map, std::size_t which, const Vec2& place);
  void cover(const ConfigurationSpace& map, std::span<const Vec2> indicators, std::size_t which);
  std::vector<std::vector<Cell>> pieces(const ConfigurationSpace& map, const std::vector<Cell>& members);
  std::vector<Cell> connected(Cell seed, double most);
  Behind look_behind(const ConfigurationSpace& map, const std::vector<Cell>& piece, const Vec2& at, const Vec2& goal);
  Behind look_on(const ConfigurationSpace& map, const std::vector<Cell>& piece, const Vec2& at) const;
  bool in_window(Cell cell) const {
    return std::abs(cell.x - center_.x) <= half_ && std::abs(cell.y - center_.y) <= half_;
  }
  std::uint8_t& mark(Cell cell) {
    return marks_[static_cast<std::size_t>((cell.y - center_.y + half_) * (2 * half_ + 1) + cell.x - center_.x +
                                           half_)];
  }

  MapPerceptionOptions options_;
  GeodesicField own_, other_;
  GoalWays goal_ways_;
  Cell center_;
  int half_ = 0;                     ///< of the window, in cells
  std::vector<std::uint8_t> marks_;  ///< of the window's cells
  std::vector<Cell> queue_;
  std::vector<Ball> balls_;  ///< by indicator
};

}  // namespace meander
