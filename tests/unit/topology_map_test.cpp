// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "base/random.hpp"
#include "round_room.hpp"
#include "topology/map_text.hpp"
#include "topology/minimal_map.hpp"
#include "topology/route.hpp"
#include "topology/trail.hpp"

namespace meander {
std::size_t allocations();  // allocation_counter.cpp
}

namespace meander::topology {
namespace {

TEST(TopologicMap, CoversTheRoomAndStaysLocalised) {
  TopologicMap map = fresh_map();
  RoundRoom room(1);
  Vec2 truth(0, 0);
  for (int i = 0; i < 6000; ++i) {
    const Observation& seen = room.next();
    map.step(seen);
    truth = seen.odometry.pose.position();
  }
  EXPECT_EQ(map.samples(), 6000);
  EXPECT_GT(map.net().cells().size(), 60);
  EXPECT_LT((map.pose().position() - truth).norm(), 0.5);
  for (int cell = 0; cell < map.net().cells().slots(); ++cell)
    EXPECT_TRUE(!map.net().cells()[cell].alive() || map.net().cells()[cell].position.norm() < 3.3);
}

TEST(TopologicMap, ReplayedTheSameReadingsMakeTheSameMap) {
  TopologicMap first = fresh_map(), second = fresh_map();
  RoundRoom a(2), b(2);
  for (int i = 0; i < 2000; ++i) first.step(a.next());
  for (int i = 0; i < 2000; ++i) second.step(b.next());
  EXPECT_EQ(map_text(first), map_text(second));
}

TEST(TopologicMap, SavedAndReadInTheMiddleItGoesOnTheSame) {
  for (const int middle : {0, 5, 500, 1777}) {
    TopologicMap map = fresh_map();
    RoundRoom room(3), same(3);
    for (int i = 0; i < middle; ++i) map.step(room.next());
    for (int i = 0; i < middle; ++i) same.next();
    TopologicMap again = read_map_text(map_text(map), "test");
    EXPECT_EQ(map_text(again), map_text(map));
    for (int i = 0; i < 1500; ++i) {
      map.step(room.next());
      again.step(same.next());
    }
    EXPECT_EQ(map_text(again), map_text(map)) << middle;
  }
}

TEST(TopologicMap, FollowingLearnsNothingAndLinksNothingAfterwards) {
  TopologicMap map = fresh_map();
  RoundRoom room(4);
  for (int i = 0; i < 1500; ++i) map.step(room.next());
  const int cells = map.net().cells().size();
  for (int i = 0; i < 500; ++i) map.follow(room.next());
  EXPECT_EQ(map.net().cells().size(), cells);
  for (int i = 0; i < 500; ++i) map.step(room.next());
  for (int cell = 0; cell < map.net().cells().slots(); ++cell)
    for (const Link& link : map.net().cells()[cell].links)
      EXPECT_LT((map.net().cells()[cell].position - map.net().cells()[link.to].position).norm(),
                1.2);  // two cells' reach and what they moved
}

/// How much the cells and links of a map have room for.
std::size_t room_of(const CellPool& cells) {
  auto room = static_cast<std::size_t>(cells.slots());
  for (int cell = 0; cell < cells.slots(); ++cell) room += cells[cell].links.capacity();
  return room;
}

TEST(TopologicMap, AllocatesOnlyForNewCellsAndLinks) {
  TopologicMap map = fresh_map();
  RoundRoom walk(8);
  for (int i = 0; i < 5000; ++i) map.step(walk.next());
  int grown = 0;
  for (int i = 0; i < 1000; ++i) {
    const Observation& seen = walk.next();
    const std::size_t room = room_of(map.net().cells()), before = allocations();
    map.step(seen);
    const std::size_t allocated = allocations() - before;
    if (room_of(map.net().cells()) == room)
      EXPECT_EQ(allocated, 0u) << i;
    else
      ++grown;
  }
  EXPECT_LT(grown, 60);
}

TEST(TopologicMap, RefusesOtherRings) {
  TopologicMap map = fresh_map();
  Observation seen;
  seen.readings.whisker.resize(8);
  EXPECT_THROW(map.step(seen), ArgumentError);
  EXPECT_EQ(map.samples(), 0);
}

TEST(MapText, BrokenTextsAreRefusedInOneLine) {
  TopologicMap map = fresh_map();
  RoundRoom room(5);
  for (int i = 0; i < 300; ++i) map.step(room.next());
  const std::string text = map_text(map);
  Stream stream(5, "damage");
  for (int i = 0; i < 300; ++i) {
    std::string broken = text;
    const auto at = static_cast<std::size_t>(stream.below(static_cast<int>(text.size())));
    if (stream.chance(0.5))
      broken.resize(at);
    else
      broken[at] = static_cast<char>(stream.below(256));
    if (broken == text) continue;
    EXPECT_THROW(read_map_text(broken, "test"), FileError) << i;
  }
  EXPECT_THROW(read_map_text("", "test"), FileError);
}

TEST(LinkDoubt, AWallFeltAcrossALinkSuspendsItAndAFreeWayLiftsIt) {
  GrowingNet net({}, SenseMetric(24, 24, {}), 0.35);
  std::vector<float> senses(48, 0.0f);
  const int a = net.insert({{0, 0}, senses.data()}, 0, -1), b = net.insert({{0.5, 0}, senses.data()}, 0, a);
  LinkDoubt doubt({}, 0.15, 0.15);
  std::vector<std::uint8_t> bent(24);
  for (const int i : {22, 23, 0, 1, 2}) bent[static_cast<std::size_t>(i)] = 1;  // ahead, 0.25 m away or so
  doubt.judge(net, {0, 0, 0}, bent, 100);
  EXPECT_EQ(net.cells().find(a, b)->doubt, 1);
  EXPECT_FALSE(net.cells().find(a, b)->suspended);
  doubt.judge(net, {0, 0, 0}, bent, 101);
  EXPECT_TRUE(net.cells().find(b, a)->suspended);
  std::fill(bent.begin(), bent.end(), std::uint8_t{0});
  for (int i = 0; i < 20; ++i) doubt.judge(net, {0.25, 0, 0}, bent, 102 + i);
  EXPECT_FALSE(net.cells().find(a, b)->suspended);
}

TEST(LinkDoubt, DrivingASuspendedLinkBringsItBack) {
  GrowingNet net({}, SenseMetric(24, 24, {}), 0.35);
  std::vector<float> senses(48, 0.0f);
  const auto shown = [&](double x) { return net.present({{x, 0}, senses.data()}, 0).cell; };
  const int a = shown(0), b = shown(0.5);
  net.cells().connect(a, b, {.doubt = 2, .suspended = true});
  EXPECT_EQ(shown(0), a);
  EXPECT_FALSE(net.cells().find(a, b)->suspended);
  EXPECT_EQ(net.cells().find(a, b)->doubt, 0);
}

TEST(LinkDoubt, AWallThatACellExpectsIsNoSurprise) {
  GrowingNet net({}, SenseMetric(24, 24, {}), 0.35);
  std::vector<float> senses(48, 0.0f);
  senses[0] = 0.8f;
  const int a = net.insert({{0, 0}, senses.data()}, 0, -1), b = net.insert({{0.5, 0}, senses.data()}, 0, a);
  LinkDoubt doubt({}, 0.15, 0.15);
  std::vector<std::uint8_t> bent(24);
  for (const int i : {22, 23, 0, 1, 2}) bent[static_cast<std::size_t>(i)] = 1;
  for (int i = 0; i < 10; ++i) doubt.judge(net, {0, 0, 0}, bent, 100 + i);
  EXPECT_EQ(net.cells().find(a, b)->doubt, 0);
}

TEST(LinkDoubt, ArcsOfWhiskersBecomePiecesOfWall) {
  std::vector<std::uint8_t> bent(24);
  std::vector<WallPiece> walls;
  felt_walls(bent, 0.15, 0.15, {0, 0, 0}, walls);
  EXPECT_TRUE(walls.empty());
  bent[5] = 1;  // alone: a false contact
  felt_walls(bent, 0.15, 0.15, {0, 0, 0}, walls);
  EXPECT_TRUE(walls.empty());
  bent[7] = 1;  // 6 is missed
  felt_walls(bent, 0.15, 0.15, {1, 2, kPi / 2}, walls);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_NEAR(walls[0].bearing, wrap_angle(kPi / 2 + kPi / 2), 1e-9);
  std::fill(bent.begin(), bent.end(), std::uint8_t{1});
  felt_walls(bent, 0.15, 0.15, {0, 0, 0}, walls);
  EXPECT_EQ(walls.size(), 3u);
}

TEST(Route, GoesTheShortWayAndAroundWhatIsSuspended) {
  CellPool cells(0);
  const auto at = [&](double x, double y) { return cells.add({x, y}, nullptr, 0); };
  const int a = at(0, 0), b = at(1, 0), c = at(2, 0), d = at(1, 1), e = at(9, 9);
  cells.connect(a, b, {});
  cells.connect(b, c, {});
  cells.connect(a, d, {});
  cells.connect(d, c, {});
  EXPECT_EQ(*route(cells, a, c), (std::vector<int>{a, b, c}));
  cells.connect(b, c, {.suspended = true});
  EXPECT_EQ(*route(cells, a, c), (std::vector<int>{a, d, c}));
  cells.disconnect(a, d);
  EXPECT_EQ(*route(cells, a, c), (std::vector<int>{a, b, c}));  // better than none
  EXPECT_FALSE(route(cells, a, e));
  EXPECT_EQ(*route(cells, e, e), (std::vector<int>{e}));
}

TEST(Trail, FindsTheStretchOfWayInTheMap) {
  TopologicMap map = fresh_map();
  RoundRoom room(6);
  for (int i = 0; i < 4000; ++i) map.step(room.next());
  Trail trail(40, 0.05, map.net().metric().stride());
  EXPECT_FALSE(trail.find(map.net(), 0.35));
  const Vec2 wrong(1.5, -0.8);
  for (int i = 0; i < 200; ++i) {
    map.follow(room.next());
    Situation believed = map.situation();
    believed.position += wrong;
    trail.add(believed);
  }
  const auto place = trail.find(map.net(), 0.35);
  ASSERT_TRUE(place);
  EXPECT_LT((place->position - map.pose().position()).norm(), 0.5);
}

TEST(MinimalMap, PlacesShareFewTouchesAndLights) {
  TopologicMap map = fresh_map();
  MinimalMap minimal({}, {}, {}, 24, 24);
  RoundRoom room(7);
  for (int i = 0; i < 5000; ++i) {
    map.step(room.next());
    minimal.present(map.situation(), i);
  }
  const CellPool& places = minimal.geometry().cells();
  EXPECT_LT(2 * minimal.touch().cells().size(), places.size());
  EXPECT_LT(map_bytes(minimal, 4), map_bytes(map.net(), 4) / 3);
  int told = 0;
  for (int place = 0; place < places.slots(); ++place) {
    if (!places[place].alive()) continue;
    const SenseLink light = minimal.light_of(place), touch = minimal.touch_of(place);
    EXPECT_TRUE(light.cell < 0 || minimal.light().cells().alive(light.cell));
    EXPECT_TRUE(touch.cell < 0 || minimal.touch().cells().alive(touch.cell));
    told += light.cell >= 0 && touch.cell >= 0;
  }
  EXPECT_GT(told, places.size() / 2);
}

}  // namespace
}  // namespace meander::topology
