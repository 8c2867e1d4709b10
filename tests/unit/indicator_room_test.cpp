// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What a way costs where little room is left, and where a wall is suspected.
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "indicator/grid_way.hpp"

namespace meander {
namespace {

TEST(ConfigurationSpace, CountsWhatIsClosedAndWhatIsInDoubtAsItComesAndGoes) {
  Stream random(2, "space");
  ConfigurationSpace map(40, 30, {0.1, {}}, 0.25, 0.4);
  for (int i = 0; i < 3000; ++i) map.set({random.below(40), random.below(30)}, static_cast<Known>(random.below(4)));
  for (int y = 4; y < 26; ++y)
    for (int x = 4; x < 36; ++x) {
      int closed = 0, all = 0;
      bool doubtful = false;
      for (int v = 0; v < 30; ++v)
        for (int u = 0; u < 40; ++u) {
          const int away = (u - x) * (u - x) + (v - y) * (v - y);
          const Known known = map.known({u, v});
          all += away <= 16;
          closed += away <= 16 && known != Known::free;
          doubtful = doubtful || (away <= 6 && (known == Known::wall || known == Known::suspected));
        }
      EXPECT_EQ(map.doubtful({x, y}), doubtful);
      EXPECT_EQ(map.crowded({x, y}, all), closed);
    }
}

TEST(ConfigurationSpace, NothingIsExpectedBehindASuspectedWall) {
  ConfigurationSpace map(40, 40, {0.05, {}}, 0.1);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 20; ++x) map.set({x, y}, Known::free);
  EXPECT_TRUE(map.frontier({19, 20}));
  for (int y = 15; y <= 25; ++y) map.set({21, y}, Known::suspected);
  EXPECT_FALSE(map.frontier({19, 20}));
  EXPECT_TRUE(map.free({19, 20}));
  EXPECT_TRUE(map.open({20, 20}));  // it may be gone through all the same
  EXPECT_TRUE(map.frontier({19, 35}));
}

/// A corridor of 1 m along x.
ConfigurationSpace corridor(double width) {
  ConfigurationSpace map(120, 40, {0.05, {}}, 0.225, 0.45);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 120; ++x) {
      const bool inside = std::abs(0.05 * (y + 0.5) - 1) < width / 2 && x > 2 && x < 117;
      map.set({x, y}, inside ? Known::free : Known::wall);
    }
  return map;
}

TEST(GeodesicField, WaysThatCostRoomKeepToTheMiddle) {
  for (const double width : {1.0, 0.8, 0.6}) {
    const ConfigurationSpace map = corridor(width);
    const Cell from{10, width > 0.7 ? 16 : 18}, to{110, 21};
    GeodesicField field;
    field.spread(map, to, 1e6, false, WayCost::room);
    const std::vector<Cell> way = way_down(field, from);
    ASSERT_FALSE(way.empty()) << width;
    for (const Cell cell : way)
      if (cell.x > 30 && cell.x < 90) {
        EXPECT_LE(std::abs(0.05 * (cell.y + 0.5) - 1), 0.11) << width;
      }
  }
}

TEST(GeodesicField, RoomCostsNoLessThanLengthAndReachesTheSame) {
  Stream random(3, "field");
  for (int trial = 0; trial < 20; ++trial) {
    ConfigurationSpace map(60, 50, {0.05, {}}, 0.1, 0.3);
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 60; ++x) map.set({x, y}, random.below(25) == 0 ? Known::wall : Known::free);
    const Cell start{random.below(60), random.below(50)};
    GeodesicField length, room;
    length.spread(map, start, 1e6);
    room.spread(map, start, 1e6, false, WayCost::room);
    EXPECT_EQ(length.reached().size(), room.reached().size());
    for (const Cell cell : length.reached()) EXPECT_GE(room.at(cell), length.at(cell) - 1e-9);
    for (const Cell cell : room.reached()) {
      const std::vector<Cell> way = way_down(room, cell);
      ASSERT_FALSE(way.empty());
      EXPECT_EQ(way.back(), start);
    }
  }
}

TEST(GeodesicField, EndsBeyondACellWithTheSameWayFromThere) {
  Stream random(4, "until");
  for (int map = 0; map < 30; ++map) {
    ConfigurationSpace space(80, 60, {0.05, {}}, 0.06, 0.2);
    for (int i = 0; i < 80 * 60; ++i) space.set({i % 80, i / 80}, random.chance(0.02) ? Known::wall : Known::free);
    GeodesicField all, some;
    for (const WayCost cost : {WayCost::length, WayCost::room})
      for (int i = 0; i < 20; ++i) {
        const Cell start{random.below(80), random.below(60)}, until{random.below(80), random.below(60)};
        all.spread(space, std::span(&start, 1), 1e9, false, cost);
        some.spread(space, std::span(&start, 1), 1e9, false, cost, nullptr, until);
        EXPECT_EQ(some.at(until), all.at(until));
        EXPECT_EQ(way_down(some, until), way_down(all, until));
        EXPECT_LE(some.reached().size(), all.reached().size());
      }
  }
}

TEST(GeodesicField, TakesNoMoreRoomThanTheMapAndIsEmptyWhenItIsCleared) {
  ConfigurationSpace map(200'000, 3, {0.05, {}}, 0.01);
  for (int x = 0; x < map.width(); ++x) map.set({x, 1}, Known::free);
  GeodesicField field;
  field.spread(map, Cell{0, 1}, 1e9);
  EXPECT_EQ(field.reached().size(), 200'000u);
  EXPECT_NEAR(field.at({199'999, 1}), 199'999 * 0.05, 1e-6);
  const std::vector<Cell> ends = {{0, 1}, {199'999, 1}};
  field.spread(map, ends, 1e9);
  EXPECT_NEAR(field.at({100'000, 1}), 99'999 * 0.05, 1e-6);
  field.clear();
  EXPECT_TRUE(field.reached().empty());
  EXPECT_FALSE(std::isfinite(field.at({0, 1})));
}

TEST(GridWay, ARobotInACellOfAPlaceIsAtThePlace) {
  Stream random(5, "place");
  ConfigurationSpace map(60, 60, {0.05, {}}, 0.1);
  for (int i = 0; i < 3600; ++i)
    map.set({random.below(60), random.below(60)}, random.chance(0.1) ? Known::wall : Known::free);
  for (int i = 0; i < 200; ++i) {
    const Vec2 place(random.uniform(0.5, 2.5), random.uniform(0.5, 2.5));
    const Cell own = map.frame().cell(place);
    const std::vector<Cell> cells = cells_at(map, place, 0.3, false);
    if (map.free(own)) {
      EXPECT_EQ(cells, std::vector<Cell>{own});
    }
    for (const Cell cell : cells) {
      EXPECT_TRUE(map.free(cell));
      const Vec2 corner(random.uniform(-0.025, 0.025), random.uniform(-0.025, 0.025));
      EXPECT_LE((map.frame().center(cell) + corner - place).norm(), 0.3);
    }
  }
}

}  // namespace
}  // namespace meander
