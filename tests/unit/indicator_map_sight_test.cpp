// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The explorer on ports that a map tells: a robot that sees perfectly, three metres far, and moves from cell to cell.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/angle.hpp"
#include "grid/labyrinth.hpp"
#include "indicator/explorer.hpp"
#include "indicator/map_sight.hpp"

namespace meander {
namespace {

constexpr double kCell = 0.05, kSight = 3.0, kReach = 0.225;

/// The walls of a labyrinth with corridors of 1 m, a cell thick.
Grid<std::uint8_t> walls_of(const Labyrinth& labyrinth) {
  constexpr int kSide = 20;
  Grid<std::uint8_t> walls(labyrinth.columns() * kSide + 1, labyrinth.rows() * kSide + 1, 0, {kCell, {}});
  for (int y = 0; y < labyrinth.rows(); ++y)
    for (int x = 0; x < labyrinth.columns(); ++x)
      for (int i = 0; i <= kSide; ++i) {
        const int left = x * kSide, low = y * kSide;
        if (!labyrinth.open({x, y}, 0)) walls[{left + kSide, low + i}] = 1;
        if (!labyrinth.open({x, y}, 1)) walls[{left + i, low + kSide}] = 1;
        if (!labyrinth.open({x, y}, 2)) walls[{left, low + i}] = 1;
        if (!labyrinth.open({x, y}, 3)) walls[{left + i, low}] = 1;
      }
  return walls;
}

class Robot {
 public:
  Robot(const Labyrinth& labyrinth, const Vec2& goal)
      : walls_(walls_of(labyrinth)),
        map_(walls_.width(), walls_.height(), walls_.frame, kReach),
        goal_(goal),
        explorer_(goal) {
    explorer_.perceive = [this](IndicatorGraph& graph, IndicatorId here) {
      sight_.look(graph, here, map_, goal_);
      if (++looks_ % 4 == 0) expect_as_if_told_anew(graph, here);
    };
  }

  Ending run(const Vec2& start) {
    at_ = start;
    explorer_.begin();
    Percept percept;
    for (;;) {
      see();
      percept.position = at_;
      const Decision& decision = explorer_.step(percept);
      if (decision.ending != Ending::driving) return decision.ending;
      percept = {};
      percept.blocked = !drive(decision, percept.walked);
    }
  }

  const Explorer& explorer() const { return explorer_; }
  const ConfigurationSpace& map() const { return map_; }
  const Vec2& at() const { return at_; }

 private:
  /// What was kept from earlier looks is what a look without memory tells.
  void expect_as_if_told_anew(const IndicatorGraph& graph, IndicatorId here) const {
    std::vector<Vec2> places;
    for (const IndicatorId id : graph.ids()) places.push_back(graph.get(id).position);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if ((places[i] - graph.get(here).position).norm() > 3.2) continue;
      const std::vector<MapPort> anew = MapPerception().ports(map_, places, i, goal_);
      const std::vector<Port>& kept = graph.get(graph.ids()[i]).ports;
      ASSERT_EQ(kept.size(), anew.size());
      for (std::size_t p = 0; p < anew.size(); ++p) {
        EXPECT_EQ(kept[p].direction, anew[p].direction);
        EXPECT_EQ(kept[p].bound, anew[p].bound);
      }
    }
  }
  void see() {
    for (int ray = 0; ray < 400; ++ray) {
      const SinCos way = sin_cos(wrap_angle(ray * kPi / 200));
      for (double r = 0; r < kSight; r += 0.7 * kCell) {
        const Cell cell = map_.frame().cell(at_ + r * Vec2(way.cos, way.sin));
        const bool wall = walls_.at(cell, 1) != 0;
        if (map_.known(cell) == Known::nothing) map_.set(cell, wall ? Known::wall : Known::free);
        if (wall) break;
      }
    }
  }
  Vec2 aim(const Decision& decision) const {
    if (decision.out.port >= 0 && !decision.back) return port_position(explorer_.graph(), decision.out);
    return explorer_.graph().get(*decision.to).position;
  }
  /// Cell by cell down the field of the aim; to the goal as soon as a free way of three metres leads there.
  bool drive(const Decision& decision, double& walked) {
    Vec2 aim = this->aim(decision);
    for (int moves = 0; moves < 2000; ++moves) {
      if (moves % 4 == 0) {
        see();
        field_.spread(map_, map_.frame().cell(goal_), 3);
        if (std::isfinite(field_.at(here()))) aim = goal_;
        field_.spread(map_, map_.frame().cell(aim), 4.5);
      }
      if (here() == map_.frame().cell(aim)) {
        at_ = aim;
        return true;
      }
      Cell best = here();
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell next{here().x + dx, here().y + dy};
          if (field_.at(next) < field_.at(best)) best = next;
        }
      if (best == here()) return false;
      walked += (map_.frame().center(best) - at_).norm();
      at_ = map_.frame().center(best);
      EXPECT_FALSE(map_.blocked(best));
    }
    return false;
  }
  Cell here() const { return map_.frame().cell(at_); }

  Grid<std::uint8_t> walls_;
  ConfigurationSpace map_;
  Vec2 goal_;
  MapSight sight_;
  Explorer explorer_;
  GeodesicField field_;
  Vec2 at_{0, 0};
  int looks_ = 0;
};

TEST(MapSight, TheExplorerReachesItsGoalOnPortsOfAMap) {
  for (const double loops : {0.0, 0.1})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Labyrinth cells = make_labyrinth({.seed = seed, .columns = 6, .rows = 6, .loops = loops});
      const double shortest = cells.steps_from({0, 0})[{5, 5}];
      Robot robot(cells, {5.5, 5.5});
      double last = 0;
      for (int run = 0; run < 3; ++run) {
        EXPECT_EQ(robot.run({0.5, 0.5}), Ending::reached)
            << "seed " << seed << " " << robot.explorer().decision().reason;
        EXPECT_LT((robot.at() - Vec2(5.5, 5.5)).norm(), 0.3);
        last = robot.explorer().state().walked;
      }
      EXPECT_LT(last, 2.5 * shortest) << "seed " << seed;
    }
}

TEST(MapSight, AGoalThatIsWalledInIsGivenUpWhenTheMapSaysSo) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    Labyrinth cells = make_labyrinth({.seed = seed, .columns = 5, .rows = 5, .loops = 0.1});
    cells.set_open({4, 4}, 2, false);
    cells.set_open({4, 4}, 3, false);
    Robot robot(cells, {4.5, 4.5});
    EXPECT_EQ(robot.run({0.5, 0.5}), Ending::no_passable_direction);
    GeodesicField field;
    field.spread(robot.map(), robot.map().frame().cell(robot.at()), 1e9, true);
    EXPECT_FALSE(std::isfinite(field.at(robot.map().frame().cell({4.5, 4.5})))) << "seed " << seed;
  }
}

}  // namespace
}  // namespace meander
