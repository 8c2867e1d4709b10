// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/sonar_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "mapping/kept_views.hpp"
#include "mapping_scans.hpp"

namespace meander {
namespace {

TEST(SonarMap, WhatManyViewsHeldFreeIsNoticedByThree) {
  float told = -5;
  SonarModel changing = telling(0);
  changing.evaluate = [&told](const SonarSweep&, const CellPlaces&, std::span<float> out) {
    std::fill(out.begin(), out.end(), told);
  };
  SonarMap map(nomad(), changing);
  const Cell place{2, 3};
  const auto look_from = [&](int k, double distance) {
    const Vec2 at = map.local().center(place) + distance * Pose2{0, 0, 0.4 + k * kPi / 4}.direction();
    for (int scan = 0; scan < 15; ++scan) map.update(seen_from({at.x(), at.y(), 0}));
  };
  for (int k = 0; k < 8; ++k)
    for (const double distance : {0.6, 1.3}) look_from(k, distance);
  EXPECT_NEAR(map.local().log_odds(place), -map.local().limit(), 0.01);
  told = 5;
  for (int k = 0; k < 3; ++k) look_from(k, 0.6);
  EXPECT_NEAR(map.local().log_odds(place), map.local().limit(), 0.01);
  EXPECT_NEAR(map.global()->log_odds(place), map.local().log_odds(place), 1e-4);
}

TEST(SonarMap, RefusedScanLeavesBothMapsAsTheyWere) {
  bool fails = false;
  SonarModel model = wavy();
  model.evaluate = [&fails, evaluate = model.evaluate](const SonarSweep& sweep, const CellPlaces& cells,
                                                       std::span<float> out) {
    if (fails) fail("no");
    evaluate(sweep, cells, out);
  };
  SonarMap map(nomad(), model);
  map.update(seen_from({1, 2, 0}, 1));
  const Cell low = map.local().low();
  const std::vector<float> local = map.local().log_odds().cells(), global = map.global()->log_odds().cells();
  Observation few = seen_from({4, 2, 0});
  few.readings.sonar.pop_back();
  EXPECT_THROW(map.update(few), ArgumentError);
  EXPECT_THROW(map.update(seen_from({1e300, 0, 0})), ArgumentError);
  fails = true;
  EXPECT_THROW(map.update(seen_from({4, 2, 0})), ArgumentError);
  EXPECT_EQ(map.local().low().x, low.x);
  EXPECT_EQ(map.local().log_odds().cells(), local);
  EXPECT_EQ(map.global()->log_odds().cells(), global);
  EXPECT_EQ(map.scans(), 1);
}

TEST(GlobalMap, FullOneTakesNothingMore) {
  GlobalMap map(0.05, 4);
  const std::vector<float> one{1};
  const auto tile = [](std::size_t i) { return Cell{128 * static_cast<int>(i), 0}; };
  for (std::size_t i = 0; i + 1 < GlobalMap::kMostTiles; ++i) map.add(tile(i), 1, one);
  const std::size_t before = map.bytes();
  const std::vector<float> four{1, 1, 1, 1};
  EXPECT_THROW(map.add({-1, -1}, 2, four), Error) << "four tiles, of which one is there";
  EXPECT_EQ(map.bytes(), before);
  EXPECT_EQ(map.log_odds(Cell{0, 0}), 1);
  map.add({-1, 0}, 1, one);
  EXPECT_THROW(map.check_room({-1, -1}, 1), Error);
}

TEST(GlobalMap, EqualsTheLocalMapWhileThatStaysInPlace) {
  LocalMap local(nomad(), wavy());
  GlobalMap global(0.05, local.limit());
  Stream random(5, "global");
  for (int scan = 0; scan < 60; ++scan) {
    local.step(seen_from({-0.02 + 0.01 * random.uniform(), 127 * 0.05, random.uniform(-3, 3)}, random.uniform(0.2, 6)));
    global.add(local.low(), local.options().size, local.increments());
  }
  const Grid<float> window = local.log_odds(), all = global.log_odds();
  EXPECT_EQ(all.width(), 60);
  EXPECT_EQ(all.height(), 60);
  EXPECT_EQ(all.cells(), window.cells());
  EXPECT_NEAR(all.frame.origin.x, window.frame.origin.x, 1e-12);
}

TEST(SonarMap, ViewThatLeftTheWindowCountsOnceEverywhere) {
  SonarMap map(nomad(), telling(0.5F));
  const Cell place = map.local().cell({0.5, 1});
  for (int visit = 0; visit < 5; ++visit) {
    for (int scan = 0; scan < 3; ++scan) map.update(seen_from({0, 0, 0}));
    EXPECT_NEAR(map.local().log_odds(place), 0.5, 0.05) << "the window forgets what leaves it";
    EXPECT_NEAR(map.global()->log_odds(place), 0.5, 0.05) << "the same view of the same place";
    map.update(seen_from({10, 0, 0}));
    EXPECT_EQ(map.local().log_odds(place), 0);
  }
  map.update(seen_from({1.3, 0.2, 0}));
  EXPECT_NEAR(map.global()->log_odds(place), 1, 0.05) << "another view adds up";
  map.clear();
  map.update(seen_from({10, 0, 0}));
  map.update(seen_from({0, 0, 0}));
  EXPECT_NEAR(map.global()->log_odds(place), 0.5, 0.05) << "cleared maps know no views";
}

/// Only near cells are told of, so that a small and a wide window see the same.
TEST(SonarMap, IsThatOfAWindowThatNothingLeaves) {
  SonarModel near = telling(0);
  near.evaluate = [](const SonarSweep& sweep, const CellPlaces& cells, std::span<float> out) {
    const auto told = static_cast<float>(sweep.ranges[3] - 3);
    for (std::size_t i = 0; i < cells.size(); ++i) out[i] = cells.range[i] < 0.8F ? told : 0;
  };
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Stream random(seed, "windows");
    LocalMapOptions small = by(Fusion::viewbin);
    small.size = 20;
    small.resolution = 0.1;
    small.fusion.view_range = 0.3;
    LocalMapOptions wide = small;
    wide.size = 120;
    SonarMap map(nomad(), near, small), all(nomad(), near, wide);
    Vec2 at(0, 0);
    for (int step = 0; step < 500; ++step) {
      at += Vec2(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
      if (step % 40 == 39) at = Vec2(random.uniform(-2, 2), random.uniform(-2, 2));
      at = at.cwiseMax(Vec2(-2.5, -2.5)).cwiseMin(Vec2(2.5, 2.5));
      const Observation seen = seen_from({at.x(), at.y(), random.uniform(-3, 3)}, random.uniform(0.2, 6));
      map.update(seen);
      all.update(seen);
    }
    int known = 0, others = 0;
    for (int y = -30; y < 30; ++y)
      for (int x = -30; x < 30; ++x) {
        ASSERT_NEAR(all.global()->log_odds({x, y}), all.local().log_odds({x, y}), 1e-4) << x << " " << y;
        others += std::abs(map.global()->log_odds({x, y}) - all.global()->log_odds({x, y})) > 1e-4;
        known += map.global()->log_odds({x, y}) != 0;
      }
    EXPECT_GT(known, 1000);
    EXPECT_LE(others, 3) << "on the border of two views, which is rounded";
  }
}

TEST(KeptViews, KeepWhatTheyAreGivenAndNoMoreThanTheyMay) {
  KeptViews kept(24, 20'000);
  EXPECT_EQ(kept.opinion({-1, 5}, 3), KeptViews::kNone);
  EXPECT_EQ(kept.sum({-1, 5}), 0);
  kept.keep_opinion({-1, 5}, 3, -127);
  kept.keep_sum({-1, 5}, 300);
  EXPECT_EQ(kept.opinion({-1, 5}, 3), -127);
  EXPECT_EQ(kept.opinion({-1, 5}, 4), KeptViews::kNone);
  EXPECT_EQ(kept.opinion({0, 5}, 3), KeptViews::kNone);
  EXPECT_EQ(kept.sum({-1, 5}), 300);
  EXPECT_EQ(kept.sum({31, 5}), 0);
  EXPECT_GT(kept.bytes(), 5'000U);
  for (int tile = 0; kept.bytes() < 20'000; ++tile) {
    EXPECT_NO_THROW(kept.check_room());
    kept.keep_opinion({32 * tile, 0}, 0, 1);
  }
  EXPECT_THROW(kept.check_room(), Error);
  kept.clear();
  EXPECT_EQ(kept.bytes(), 0U);
  EXPECT_EQ(kept.opinion({-1, 5}, 3), KeptViews::kNone);
}

TEST(GlobalMap, TilesAreOneMap) {
  Stream random(6, "tiles");
  GlobalMap global(0.05, 4);
  Grid<float> plain(700, 700, 0);
  for (int add = 0; add < 200; ++add) {
    const int size = 1 + random.below(200);
    const Cell low{-350 + random.below(500), -350 + random.below(500)};
    std::vector<float> increments(static_cast<std::size_t>(size * size));
    for (float& value : increments) value = static_cast<float>(random.normal());
    global.add(low, size, increments);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        float& cell = plain[{low.x + x + 350, low.y + y + 350}];
        cell = std::clamp(cell + increments[static_cast<std::size_t>(y * size + x)], -4.0F, 4.0F);
      }
  }
  for (int y = -350; y < 350; ++y)
    for (int x = -350; x < 350; ++x) ASSERT_EQ(global.log_odds(Cell{x, y}), (plain[{x + 350, y + 350}]));
  EXPECT_TRUE(GlobalMap(0.05, 4).log_odds().cells().empty());
}

}  // namespace
}  // namespace meander
