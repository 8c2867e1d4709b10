// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "indicator/map_perception.hpp"

namespace meander {
namespace {

constexpr int kScale = 10;        ///< cells of a letter
constexpr double kCell = 0.05;    ///< [m]: a letter is half a metre
constexpr double kReach = 0.225;  ///< of a robot of 0.20 m

/// A map drawn in letters, top row first: '#' wall, '.' free, ' ' unknown.
ConfigurationSpace drawn(const std::vector<std::string>& rows) {
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows[0].size());
  ConfigurationSpace map(width * kScale, height * kScale, {kCell, {}}, kReach);
  for (int y = 0; y < height * kScale; ++y)
    for (int x = 0; x < width * kScale; ++x) {
      const char letter = rows[static_cast<std::size_t>(height - 1 - y / kScale)][static_cast<std::size_t>(x / kScale)];
      map.set({x, y}, letter == '#' ? Known::wall : letter == '.' ? Known::free : Known::nothing);
    }
  return map;
}

/// Middle of a letter's corner: corridors are two letters wide.
Vec2 at(double column, double row) { return {column * 0.5, row * 0.5}; }

std::vector<MapPort> ports(const ConfigurationSpace& map, const std::vector<Vec2>& indicators, const Vec2& goal,
                           std::size_t which = 0) {
  return MapPerception().ports(map, indicators, which, goal);
}

TEST(ConfigurationSpace, CountsWallsThatComeAndGo) {
  Stream random(1, "space");
  ConfigurationSpace map(40, 30, {0.1, {}}, 0.25);
  std::vector<Cell> walls;
  for (int i = 0; i < 3000; ++i)
    map.set({random.below(42) - 1, random.below(32) - 1}, static_cast<Known>(random.below(3)));
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      bool near = false;
      for (int v = 0; v < 30; ++v)
        for (int u = 0; u < 40; ++u)
          near = near || (map.known({u, v}) == Known::wall && (u - x) * (u - x) + (v - y) * (v - y) <= 6);
      EXPECT_EQ(map.blocked({x, y}), near);
    }
  EXPECT_TRUE(map.blocked({-1, 5}));
}

TEST(GeodesicField, GoesRoundWalls) {
  const ConfigurationSpace map =
      drawn({"##########", "#........#", "#........#", "#..######.", "#..      #", "##########"});
  GeodesicField field;
  field.spread(map, map.frame().cell(at(2, 1.9)), 100);
  EXPECT_EQ(field.at(map.frame().cell(at(2, 1.9))), 0);
  EXPECT_NEAR(field.at(map.frame().cell(at(8, 4))), 3.6, 0.3);
  EXPECT_TRUE(std::isinf(field.at({0, 0})));
  field.spread(map, map.frame().cell(at(2, 1.9)), 1);
  EXPECT_TRUE(std::isinf(field.at(map.frame().cell(at(8, 4)))));
  double last = 0;
  for (const Cell cell : field.reached()) {
    EXPECT_GE(field.at(cell), last);
    last = field.at(cell);
  }
}

// A crossing of corridors of one metre: to the east all is unknown beyond what was seen, to the north the passage ends
// in sight, to the west it goes on into the unknown.
std::vector<std::string> crossing() {
  return {"################",  //
          "#######..#######",  //
          "#######..#######",  //
          "#######..#######",  //
          "#######..#######",  //
          " .............. ",  //
          " .............. ",  //
          "################"};
}

TEST(MapPerception, APassageThatIsSeenToBeBlindIsNoPort) {
  const ConfigurationSpace map = drawn(crossing());
  const Vec2 here = at(8, 2);
  const auto found = ports(map, {here}, at(30, 2));
  ASSERT_EQ(found.size(), 2u);
  for (const MapPort& port : found) {
    EXPECT_NEAR(std::abs(port.position.x() - here.x()), 1.25, 0.15);
    EXPECT_NEAR(port.position.y(), here.y(), 0.15);
    EXPECT_NEAR(port.way, 1.3, 0.15);
    EXPECT_GE(port.bound, (here - at(30, 2)).norm() - 0.2);
  }
  EXPECT_NE(found[0].position.x() > here.x(), found[1].position.x() > here.x());
}

TEST(MapPerception, ThePassageIsAPortWhenTheGoalLiesInIt) {
  const ConfigurationSpace map = drawn(crossing());
  EXPECT_EQ(ports(map, {at(8, 2)}, at(8, 6.5)).size(), 3u);
}

TEST(MapPerception, WhatAnotherBallCoversIsNoPort) {
  const ConfigurationSpace map = drawn(crossing());
  const std::vector<Vec2> both = {at(8, 2), at(10.8, 2)};
  EXPECT_EQ(ports(map, both, at(30, 2), 0).size(), 1u);
  const auto second = ports(map, both, at(30, 2), 1);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_GT(second[0].position.x(), at(10.8, 2).x());
}

TEST(MapPerception, AFrontierInsideTheBallIsAPort) {
  const ConfigurationSpace map = drawn({"########", "#......#", "#......#", "#...  .#", "#...  .#", "########"});
  const auto found = ports(map, {at(2.5, 2)}, at(5, 2));
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const MapPort& port) { return port.way < 1.25; }));
}

TEST(MapPerception, PortsDoNotChangeWhileTheRobotMovesAboutAnIndicator) {
  // [DG] Figure 3: the map grows where the robot looks; what it knew stays.
  ConfigurationSpace map = drawn(crossing());
  const Vec2 here = at(8, 2);
  const auto before = ports(map, {here}, at(30, 2));
  MapPerception perception;
  for (int step = 0; step < 20; ++step) {
    const auto now = perception.ports(map, std::vector<Vec2>{here}, 0, at(30, 2));
    ASSERT_EQ(now.size(), before.size());
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_EQ(now[i].position, before[i].position);
    map.set({155 + step / 4, 25 + step % 4}, Known::free);
  }
}

TEST(MapPerception, ABallThatItsWindowDoesNotHoldIsRefused) {
  EXPECT_THROW(MapPerception({.ball = 4, .shell = 0.12, .window = 4}), ArgumentError);
}

}  // namespace
}  // namespace meander
