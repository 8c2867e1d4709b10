// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"
#include "round_room.hpp"
#include "topology/map_text.hpp"
#include "topology/route.hpp"
#include "topology/route_guide.hpp"

namespace meander::topology {
namespace {

double longest_link(const CellPool& cells) {
  double longest = 0;
  for (int cell = 0; cell < cells.slots(); ++cell)
    for (const Link& link : cells[cell].links)
      longest = std::max(longest, (cells[cell].position - cells[link.to].position).norm());
  return longest;
}

TEST(TopologicMap, RunsThatBeginElsewhereAreNotLinkedToTheLast) {
  for (const bool saved : {false, true}) {
    TopologicMap map = fresh_map();
    RoundRoom room(12);
    for (int i = 0; i < 300; ++i) map.step(room.next());
    map.begin(Pose2{40, 30, 0});
    EXPECT_EQ(map.pose().x, 40);
    EXPECT_EQ(map.net().winner(), -1);
    if (saved) map = read_map_text(map_text(map), "test");
    RoundRoom other(13);  // its odometry begins at 0
    map.step(other.next());
    EXPECT_LT((map.pose().position() - Vec2(40, 30)).norm(), 1e-9);
    for (int i = 0; i < 300; ++i) map.step(other.next());
    EXPECT_LT(longest_link(map.net().cells()), 1.2);
    EXPECT_GT(map.pose().x, 30);
    map.begin();
    const Pose2 last = map.pose();
    RoundRoom third(14);
    map.follow(third.next());
    EXPECT_LT((map.pose().position() - last.position()).norm(), 0.2);  // but for the correction
  }
  TopologicMap empty = fresh_map();
  empty.begin();
  Observation seen = RoundRoom(15).next();
  empty.step(seen);
  EXPECT_EQ(empty.pose(), seen.odometry.pose);
}

TEST(TopologicMap, AShiftBreaksTheChainAndRefusesWhatIsNowhere) {
  TopologicMap map = fresh_map();
  RoundRoom room(16);
  for (int i = 0; i < 300; ++i) map.step(room.next());
  const std::string before = map_text(map);
  const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {2e6, -2e6, infinite, nan}) {
    EXPECT_THROW(map.shift({bad, 0}), ArgumentError);
    EXPECT_THROW(map.shift({0, bad}), ArgumentError);
    EXPECT_THROW(map.begin(Pose2{0, bad, 0}), ArgumentError);
    EXPECT_THROW(map.begin(Pose2{0, 0, bad}), ArgumentError);
  }
  EXPECT_EQ(map_text(map), before);
  map.shift({50, 0});
  for (int i = 0; i < 300; ++i) map.step(room.next());
  EXPECT_LT(longest_link(map.net().cells()), 1.2);
}

TEST(TopologicMap, ASampleThatIsRefusedLeavesItAsItWas) {
  TopologicMap map = fresh_map();
  RoundRoom room(9);
  for (int i = 0; i < 300; ++i) map.step(room.next());
  const auto refuses_all = [&] {
    const std::string before = map_text(map);
    for (const auto& [whiskers, lights] : {std::pair(8, 24), std::pair(24, 0), std::pair(0, 0)}) {
      Observation seen = room.next();
      seen.readings.whisker.resize(static_cast<std::size_t>(whiskers));
      seen.readings.light.resize(static_cast<std::size_t>(lights));
      EXPECT_THROW(map.step(seen), ArgumentError);
      EXPECT_THROW(map.follow(seen), ArgumentError);
      EXPECT_EQ(map_text(map), before);
    }
  };
  refuses_all();
  for (int i = 0; i < 50; ++i) map.follow(room.next());
  refuses_all();  // step would break off and learn again
}

TEST(MapText, TellsOfNowAsTheMapThatWasWritten) {
  TopologicMap map = fresh_map();
  RoundRoom room(10);
  for (int i = 0; i < 1200; ++i) {
    map.step(room.next());
    if (i % 100 != 99) continue;
    const TopologicMap again = read_map_text(map_text(map), "test");
    EXPECT_EQ(most_alike(again.net(), again.situation().senses), most_alike(map.net(), map.situation().senses));
    for (int k = 0; k < map.net().metric().stride(); ++k)
      EXPECT_EQ(again.situation().senses[k], map.situation().senses[k]);
    EXPECT_EQ(again.recognition().sample, map.recognition().sample);
    EXPECT_EQ(again.recognition().cell, map.recognition().cell);
    EXPECT_EQ(again.recognition().distance, map.recognition().distance);
    EXPECT_EQ(again.correction().cell, map.correction().cell);
    EXPECT_EQ(again.correction().shift, map.correction().shift);
    EXPECT_EQ(again.correction().turn, map.correction().turn);
    EXPECT_EQ(again.correction().distance, map.correction().distance);
  }
}

TEST(TopologicMap, RefusesRobotsWithoutWhiskers) {
  EXPECT_THROW(TopologicMap({}, SenseSuite{.whiskers = 0}), ArgumentError);
  EXPECT_THROW(TopologicMap({}, SenseSuite{.whiskers = -1}), ArgumentError);
  EXPECT_THROW(TopologicMap({}, SenseSuite{.lights = -1}), ArgumentError);
  EXPECT_NO_THROW(TopologicMap({}, SenseSuite{.lights = 0}));
}

TEST(RouteGuide, ResetItStillMeansTheCellOfItsMaking) {
  const auto map = std::make_shared<TopologicMap>(fresh_map());
  RoundRoom room(11);
  for (int i = 0; i < 2000; ++i) map->step(room.next());
  GrowingNet& net = map->net();
  const int goal = map->recognition().cell;
  Guide guide = route_guide(map, goal);
  guide.reset();
  EXPECT_TRUE(guide.next(room.next(), {}).subgoal);
  const std::vector<float> senses(net.cells().senses(goal), net.cells().senses(goal) + net.cells().stride());
  net.remove(goal);
  ASSERT_EQ(net.insert({{0, 0}, senses.data()}, map->samples(), -1), goal);  // the number stands for another
  for (int run = 0; run < 2; ++run) {
    const GuideStep step = guide.next(room.next(), {});
    EXPECT_FALSE(step.subgoal);
    EXPECT_EQ(step.reason, "the goal's cell is gone");
    guide.reset();
  }
}

TEST(RouteGuide, LinksThatGoWhileItIsStuckDoNoHarm) {
  // A map that learns and forgets fast under a robot that hardly moves: links and cells of the way go at any time.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    TopologicMapOptions options;
    options.net.fade = 0.9;
    const auto map = std::make_shared<TopologicMap>(options, SenseSuite{});
    RoundRoom room(20 + seed);
    for (int i = 0; i < 1500; ++i) map->step(room.next());
    Stream stream(seed, "goals");
    for (int drive = 0; drive < 5; ++drive) {
      const int goal = stream.below(map->net().cells().slots());
      if (!map->net().cells().alive(goal)) continue;
      RouteGuideOptions drive_options;
      drive_options.near = 2;
      drive_options.progress = 5;
      drive_options.patience = 2;
      drive_options.learn = true;
      Guide guide = route_guide(map, goal, drive_options);
      for (int i = 0; i < 100 && guide.next(room.next(), {}).subgoal; ++i) {
        const int told = map->correction().cell;
        EXPECT_TRUE(told < 0 || map->net().cells().alive(told));
      }
    }
  }
}

TEST(RouteGuide, AMapWhoseLinksAreNeverSuspendedStaysAsItIs) {
  for (const double suspend : {0.0, 2.0}) {
    TopologicMapOptions options;
    options.doubt.suspend = suspend;
    const auto map = std::make_shared<TopologicMap>(options, SenseSuite{});
    RoundRoom room(40);
    for (int i = 0; i < 1500; ++i) map->step(room.next());
    const CellPool& cells = map->net().cells();
    std::vector<std::vector<Link>> before;
    for (int cell = 0; cell < cells.slots(); ++cell) before.push_back(cells[cell].links);
    bool changed = false;
    for (int goal = 0; goal < cells.slots(); ++goal) {
      if (!cells.alive(goal)) continue;
      RouteGuideOptions drive_options;
      drive_options.progress = 5;  // always stuck
      drive_options.patience = 2;
      Guide guide = route_guide(map, goal, drive_options);
      for (int i = 0; i < 100 && guide.next(room.next(), {}).subgoal;) ++i;
      for (int cell = 0; cell < cells.slots(); ++cell)
        changed = changed || cells[cell].links != before[static_cast<std::size_t>(cell)];
    }
    EXPECT_EQ(changed, suspend > 0);
  }
}

}  // namespace
}  // namespace meander::topology
