// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/map_perception.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace meander {
namespace {

constexpr std::uint8_t kOwn = 1;       ///< in the ball of the indicator
constexpr std::uint8_t kFirst = 2;     ///< in the ball of an indicator that came before it
constexpr std::uint8_t kLater = 4;     ///< in the ball of one that came after it
constexpr std::uint8_t kMember = 8;    ///< of what is being cut into pieces
constexpr std::uint8_t kVisited = 16;  ///< seen behind a port
constexpr std::uint8_t kBall = kOwn | kFirst | kLater;

template <class Visit>
void for_neighbours(Cell cell, Visit visit) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (dx != 0 || dy != 0) visit(Cell{cell.x + dx, cell.y + dy});
}

/// The cell of the piece that is nearest to its middle.
Cell middle(const std::vector<Cell>& piece) {
  double x = 0, y = 0;
  for (const Cell cell : piece) x += cell.x, y += cell.y;
  x /= static_cast<double>(piece.size());
  y /= static_cast<double>(piece.size());
  const auto off = [&](Cell c) { return (c.x - x) * (c.x - x) + (c.y - y) * (c.y - y); };
  return *std::min_element(piece.begin(), piece.end(), [&](Cell a, Cell b) { return off(a) < off(b); });
}

}  // namespace

MapPerception::MapPerception(const MapPerceptionOptions& options) : options_(options) {
  validate(options);
  if (options.ball + options.shell > options.window)
    fail(
        "options 'ports.ball', 'ports.shell' and 'ports.window': a window that the ball and its shell lie in expected, "
        "got {}, {} and {} m",
        options.ball, options.shell, options.window);
}

const std::vector<Cell>& MapPerception::ball(const ConfigurationSpace& map, std::size_t which, const Vec2& place) {
  if (which >= balls_.size()) balls_.resize(which + 1);
  Ball& ball = balls_[which];
  const Cell at = map.frame().cell(place);
  const int far = static_cast<int>(options_.ball / map.resolution()) + 1;
  const bool kept = !ball.cells.empty() && ball.place == place &&
                    map.changed({at.x - far, at.y - far}, {at.x + far, at.y + far}) <= ball.version;
  if (kept) return ball.cells;
  other_.spread(map, at, options_.ball);
  ball = {place, map.version(), other_.reached()};
  return ball.cells;
}

/// Marks whose ball covers the cells of the window.
void MapPerception::cover(const ConfigurationSpace& map, std::span<const Vec2> indicators, std::size_t which) {
  const Vec2 here = indicators[which];
  center_ = map.frame().cell(here);
  half_ = static_cast<int>(options_.window / map.resolution());
  marks_.assign(static_cast<std::size_t>(2 * half_ + 1) * static_cast<std::size_t>(2 * half_ + 1), 0);
  own_.spread(map, center_, std::min(options_.ball + options_.shell, options_.window));
  for (const Cell cell : own_.reached())
    if (own_.at(cell) < options_.ball) mark(cell) |= kOwn;
  const double near = 2 * options_.ball + options_.shell;
  for (std::size_t i = 0; i < indicators.size(); ++i) {
    if (i == which || (indicators[i] - here).squaredNorm() > near * near) continue;
    for (const Cell cell : ball(map, i, indicators[i]))
      if (in_window(cell)) mark(cell) |= i < which ? kFirst : kLater;
  }
}

std::vector<MapPort> MapPerception::ports(const ConfigurationSpace& map, std::span<const Vec2> indicators,
                                          std::size_t which, const Vec2& goal) {
  if (which >= indicators.size())
    fail("ports: an indicator from 0 to {} expected, got {}", indicators.size() - 1, which);
  goal_ways_.update(map, goal);
  cover(map, indicators, which);
  std::vector<Cell> shell, frontier;
  for (const Cell cell : own_.reached()) {
    if (own_.at(cell) >= options_.ball && (mark(cell) & kBall) == 0) shell.push_back(cell);
    if (own_.at(cell) < options_.ball && (mark(cell) & kFirst) == 0 && map.frontier(cell)) frontier.push_back(cell);
  }
  std::vector<MapPort> ports;
  for (const std::vector<Cell>* members : {&shell, &frontier})
    for (const std::vector<Cell>& piece : pieces(map, *members)) {
      const Cell at = middle(piece);
      MapPort port{.position = map.frame().center(at), .direction = 0, .way = own_.at(at), .bound = 0};
      const Behind behind =
          members == &shell ? look_behind(map, piece, port.position, goal) : look_on(map, piece, port.position);
      if (!behind.worth) continue;
      const Vec2 out = port.position - indicators[which];
      port.direction = angle_of(out.y(), out.x());
      port.bound = port.way + behind.least_on;
      ports.push_back(port);
    }
  return ports;
}

/// What is connected, cut from its end where it is too wide.
std::vector<std::vector<Cell>> MapPerception::pieces(const ConfigurationSpace& map, const std::vector<Cell>& members) {
  std::vector<std::vector<Cell>> found;
  const double most = options_.piece / map.resolution();
  const auto set = [&](const std::vector<Cell>& cells) {
    for (const Cell cell : cells) mark(cell) |= kMember;
  };
  set(members);
  for (const Cell seed : members) {
    while ((mark(seed) & kMember) != 0) {
      std::vector<Cell> all = connected(seed, std::numeric_limits<double>::infinity());
      const Cell end = all.back();  // the flood from the seed came there last
      set(all);
      std::vector<Cell> piece = connected(end, most);
      if (static_cast<int>(piece.size()) >= options_.cells) found.push_back(std::move(piece));
    }
  }
  return found;
}

/// The members connected with the seed that are not farther from it than `most` cells; their marks go.
std::vector<Cell> MapPerception::connected(Cell seed, double most) {
  std::vector<Cell> piece{seed};
  mark(seed) &= static_cast<std::uint8_t>(~kMember);
  for (std::size_t i = 0; i < piece.size(); ++i)
    for_neighbours(Cell(piece[i]), [&](Cell next) {
      const double dx = next.x - seed.x, dy = next.y - seed.y;
      if (!in_window(next) || (mark(next) & kMember) == 0 || dx * dx + dy * dy > most * most) return;
      mark(next) &= static_cast<std::uint8_t>(~kMember);
      piece.push_back(next);
    });
  return piece;
}

/// What lies beyond a piece of the frontier.
MapPerception::Behind MapPerception::look_on(const ConfigurationSpace& map, const std::vector<Cell>& piece,
                                             const Vec2& at) const {
  Behind behind{false, std::numeric_limits<double>::infinity()};
  for (const Cell cell : piece) {
    const Vec2 there = map.frame().center(cell);
    behind.least_on = std::min(behind.least_on, (there - at).norm() + goal_ways_.least(there));
  }
  behind.worth = std::isfinite(behind.least_on);
  return behind;
}

/// Floods what is free outside the ball, from the piece on, within the window.
MapPerception::Behind MapPerception::look_behind(const ConfigurationSpace& map, const std::vector<Cell>& piece,
                                                 const Vec2& at, const Vec2& goal) {
  Behind behind{false, std::numeric_limits<double>::infinity()};
  const auto worth = [&](double least_on) {
    behind.worth = behind.worth || std::isfinite(least_on);
    behind.least_on = std::min(behind.least_on, least_on);
  };
  const Cell goal_cell = map.frame().cell(goal);
  queue_ = piece;
  for (const Cell cell : piece) mark(cell) |= kVisited;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const Cell cell = queue_[i];
    const Vec2 there = map.frame().center(cell);
    if (cell == goal_cell) worth((at - goal).norm());
    if (map.frontier(cell)) worth((there - at).norm() + goal_ways_.least(there));
    for_neighbours(cell, [&](Cell next) {
      if (!map.free(next)) return;
      if (!in_window(next)) return worth(goal_ways_.least(at));  // more than can be seen from here
      if ((mark(next) & (kOwn | kVisited)) != 0) return;
      mark(next) |= kVisited;
      queue_.push_back(next);
    });
  }
  for (const Cell cell : queue_) mark(cell) &= static_cast<std::uint8_t>(~kVisited);
  return behind;
}

}  // namespace meander
