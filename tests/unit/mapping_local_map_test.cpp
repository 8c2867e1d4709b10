// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/local_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/random.hpp"
#include "mapping/classic_models.hpp"
#include "mapping/network_file.hpp"
#include "mapping_scans.hpp"

namespace meander {
std::size_t allocations();  // allocation_counter.cpp

namespace {

TEST(LocalMap, OddsOfThePaperMultiply) {
  LocalMap map(nomad(), telling(0.7F), by(Fusion::bayes));
  const Vec2 place(1.012, -0.53);
  double odds = 1;
  for (int scan = 0; scan < 5; ++scan) {
    map.step(seen_from({}));
    odds *= std::exp(0.7);
    EXPECT_NEAR(map.log_odds(map.cell(place)), std::log(odds), 1e-5) << "eq. (4)";
  }
  for (int scan = 0; scan < 50; ++scan) map.step(seen_from({}));
  EXPECT_NEAR(map.log_odds(map.cell(place)), std::log(99.0), 1e-5) << "the paper's range [0.01, 0.99]";
  EXPECT_NEAR(map.log_odds(map.cell({0, 0})), -std::log(99.0), 1e-5) << "the robot's own place is free";
}

TEST(LocalMap, OrderOfUpdatesDoesNotMatterUnderTheRuleOfBayes) {
  Stream random(11, "order");
  std::vector<Observation> scans;
  for (int i = 0; i < 12; ++i)
    scans.push_back(seen_from({random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-3, 3)},
                              random.uniform(0.3, 6)));
  LocalMap forth(nomad(), wavy(), by(Fusion::bayes)), shuffled(nomad(), wavy(), by(Fusion::bayes));
  for (const Observation& scan : scans) forth.step(scan);
  for (std::size_t i = scans.size(); i > 1; --i)
    std::swap(scans[i - 1], scans[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  for (const Observation& scan : scans) shuffled.step(scan);
  // The window lies around the robot's cell: compare where both have all scans.
  for (int y = -25; y < 25; ++y)
    for (int x = -25; x < 25; ++x) {
      if (std::hypot(x, y) < 8) continue;  // the robot's own place
      ASSERT_NEAR(forth.log_odds(Cell{x, y}), shuffled.log_odds(Cell{x, y}), 1e-4) << x << " " << y;
    }
}

TEST(LocalMap, DifferentViewsAddUpInAnyOrder) {
  const std::vector<Pose2> places{{-0.9, 0, 0}, {0, -0.9, 0}, {0.9, 0, 1}, {0.05, 0.9, 2}};
  const auto fused = [&](std::vector<std::size_t> order) {
    LocalMap map(nomad(), wavy(), by(Fusion::viewbin));
    for (const std::size_t i : order) map.step(seen_from(places[i], 1 + 0.2 * static_cast<double>(i)));
    return map.log_odds(Cell{2, 3});
  };
  const float one = fused({0, 1, 2, 3});
  for (const auto& order : std::vector<std::vector<std::size_t>>{{3, 2, 1, 0}, {1, 3, 0, 2}, {2, 0, 3, 1}})
    EXPECT_NEAR(fused(order), one, 1e-5);
}

TEST(LocalMap, RobotThatStandsStillDoesNotBecomeCertain) {
  LocalMap views(nomad(), telling(0.8F), by(Fusion::viewbin)), bayes(nomad(), telling(0.8F), by(Fusion::bayes));
  for (int scan = 0; scan < 200; ++scan) {
    views.step(seen_from({0.3, 0.4, 0.5}));
    bayes.step(seen_from({0.3, 0.4, 0.5}));
  }
  const Cell there = views.cell({1, 0});
  EXPECT_NEAR(views.log_odds(there), 0.8, 0.03);
  EXPECT_NEAR(bayes.log_odds(there), bayes.limit(), 1e-5) << "the paper's rule does";
}

TEST(LocalMap, ViewComeBackToCountsOnce) {
  LocalMapOptions remembering = by(Fusion::viewbin), forgetting = remembering;
  forgetting.fusion.remember_views = false;
  LocalMap once(nomad(), telling(0.5F), remembering), again(nomad(), telling(0.5F), forgetting);
  for (int turn = 0; turn < 4; ++turn)
    for (const double x : {0.0, -1.2}) {
      once.step(seen_from({x, 0, 0}));
      again.step(seen_from({x, 0, 0}));
    }
  const Cell seen_from_two_distances = once.cell({-0.6, 1.0});
  EXPECT_NEAR(once.log_odds(seen_from_two_distances), 2 * 0.5, 0.05);
  EXPECT_GT(again.log_odds(seen_from_two_distances), 3.5);
}

TEST(LocalMap, ChangedWorldIsLearnedAnewFromTheSameView) {
  float told = 3;
  const SonarModel changing{.name = "changing",
                            .ring = nomad().sonar,
                            .reach = 10,
                            .evaluate = [&told](const SonarSweep&, const CellPlaces&, std::span<float> out) {
                              std::fill(out.begin(), out.end(), told);
                            }};
  LocalMap map(nomad(), changing);
  for (int scan = 0; scan < 20; ++scan) map.step(seen_from({}));
  told = -3;
  int scans = 0;
  while (map.log_odds(map.cell({1, 1})) > 0 && scans < 50) map.step(seen_from({})), ++scans;
  EXPECT_LE(scans, 3);
}

TEST(LocalMap, ViewThatChangesItsMindTakesBackOnlyWhatItHadSaid) {
  float told = 5;  // over the limit
  const SonarModel changing{.name = "changing",
                            .ring = nomad().sonar,
                            .reach = 10,
                            .evaluate = [&told](const SonarSweep&, const CellPlaces&, std::span<float> out) {
                              std::fill(out.begin(), out.end(), told);
                            }};
  SonarMap map(nomad(), changing);
  const Cell place{2, 3};
  const Pose2 around[] = {{-0.9, 0, 0}, {0, -0.9, 0}, {0.9, 0, 1}};
  for (const Pose2& at : around) map.update(seen_from(at));
  EXPECT_NEAR(map.local().log_odds(place), map.local().limit(), 0.01);
  told = -5;
  for (int scan = 0; scan < 30; ++scan) map.update(seen_from(around[2]));
  EXPECT_NEAR(map.local().log_odds(place), map.local().limit(), 0.01) << "two against one";
  EXPECT_NEAR(map.global()->log_odds(place), map.local().log_odds(place), 1e-5);
  for (int scan = 0; scan < 30; ++scan) map.update(seen_from(around[1]));
  EXPECT_NEAR(map.local().log_odds(place), -map.local().limit(), 0.1) << "one against two";
  EXPECT_NEAR(map.global()->log_odds(place), map.local().log_odds(place), 1e-5);
}

TEST(LocalMap, TurningCostsNothing) {
  LocalMap map(nomad(), telling(0.3F), by(Fusion::bayes));
  map.step(seen_from({4.2, 1, 0}));
  const Grid<float> before = map.log_odds();
  map.step(seen_from({4.2, 1, 2.5}));
  const Grid<float> after = map.log_odds();
  EXPECT_EQ(before.frame, after.frame);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) EXPECT_GE(std::abs(after[{x, y}]), std::abs(before[{x, y}]));
}

/// The ring buffer against a plain grid over everywhere that forgets what is outside the window.
TEST(LocalMap, SlidesLikeAPlainGridThatForgetsOutside) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Stream random(seed, "slide");
    LocalMapOptions options = by(Fusion::bayes);
    options.size = 14;
    options.resolution = 0.1;
    LocalMap map(nomad(), wavy(), options);
    constexpr int kHalf = 120;
    Grid<float> plain(2 * kHalf, 2 * kHalf, 0);
    Vec2 at(-3 + random.uniform(), random.uniform());
    for (int step = 0; step < 300; ++step) {
      at += Vec2(random.uniform(-0.25, 0.25), random.uniform(-0.25, 0.25));
      if (step % 50 == 49) at = Vec2(random.uniform(-5, 5), random.uniform(-5, 5));
      if (step % 7 == 0) at = Vec2(std::round(10 * at.x()) / 10, at.y());  // on a border between cells
      map.step(seen_from({at.x(), at.y(), random.uniform(-3, 3)}, random.uniform(0.2, 6)));
      const Cell low = map.low();
      std::size_t i = 0;
      for (int y = -kHalf; y < kHalf; ++y)
        for (int x = -kHalf; x < kHalf; ++x) {
          float& cell = plain[{x + kHalf, y + kHalf}];
          if (!map.covers({x, y}))
            cell = 0;
          else
            cell = std::clamp(cell + map.increments()[i++], -map.limit(), map.limit());
        }
      ASSERT_EQ(i, 14U * 14U);
      for (int y = low.y; y < low.y + 14; ++y)
        for (int x = low.x; x < low.x + 14; ++x)
          ASSERT_EQ((map.log_odds(Cell{x, y})), (plain[{x + kHalf, y + kHalf}])) << x << " " << y << " step " << step;
      const Cell middle = map.cell(at);
      ASSERT_EQ(middle.x, low.x + 7);
      ASSERT_EQ(middle.y, low.y + 7);
    }
  }
}

TEST(LocalMap, ComingBackFindsTheLocalMapEmptyAndTheGlobalMapFull) {
  LocalMap local(nomad(), telling(0.4F), by(Fusion::bayes));
  GlobalMap global(0.05, local.limit());
  const auto see = [&](double x) {
    local.step(seen_from({x, -7, 0}));
    global.add(local.low(), local.options().size, local.increments());
  };
  const Cell place = local.cell({-100.5, -6});
  see(-100);
  see(-100);
  EXPECT_NEAR(local.log_odds(place), 0.8, 1e-5);
  EXPECT_NEAR(global.log_odds(place), 0.8, 1e-5);
  see(-90);
  EXPECT_EQ(local.log_odds(place), 0);
  EXPECT_NEAR(global.log_odds(place), 0.8, 1e-5) << "kept";
  see(-100);
  EXPECT_NEAR(local.log_odds(place), 0.4, 1e-5);
  EXPECT_NEAR(global.log_odds(place), 1.2, 1e-5) << "one more scan, nothing twice";
}

TEST(LocalMap, TenKilometresTakeNoMoreMemoryThanTen) {
  LocalMap map(nomad(), telling(0.1F));
  GlobalMap global(0.05, map.limit());
  map.step(seen_from({}));
  const std::size_t before = map.bytes();
  for (int i = 1; i <= 20000; ++i) map.step(seen_from({0.4 * i, -0.3 * i, 0.001 * i}));
  EXPECT_EQ(map.bytes(), before);
  EXPECT_LT(before, 400'000U);
  EXPECT_NEAR(map.center(map.low()).x(), 8000 - 1.5, 0.1);
}

TEST(LocalMap, AllocatesNothingPerScan) {
  const std::string models = std::string(MEANDER_SOURCE_DIR) + "/models/nn4_ideal.txt";
  const RingLayout& ring = nomad().sonar;
  for (const SonarModel& model : {cone_model(ring), range_layer_model(ring), network_model(read_network(models)),
                                  table_model(read_network(models))})
    for (const Fusion rule : {Fusion::viewbin, Fusion::bayes}) {
      LocalMap map(nomad(), model, by(rule));
      Observation seen = seen_from({}, 1);
      Stream random(1, "readings");
      std::size_t before = 0;
      for (int scan = 0; scan < 40; ++scan) {
        seen.odometry.pose.x += 0.05;
        seen.odometry.pose.heading += 0.1;
        for (double& range : seen.readings.sonar) range = random.uniform(0.3, 3.5);
        for (Pose2& pose : seen.readings.sonar_pose) pose = seen.odometry.pose;
        if (scan == 10) before = allocations();
        map.step(seen);
      }
      EXPECT_EQ(allocations(), before) << model.name;
    }
}

TEST(LocalMap, RefusesWhatIsNoScanAndNoPlace) {
  LocalMap map(nomad(), telling(0.1F));
  Observation few = seen_from({});
  few.readings.sonar.pop_back();
  EXPECT_THROW(map.step(few), ArgumentError);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300, -1e9})
    EXPECT_THROW(map.step(seen_from({bad, 0, 0})), ArgumentError);
  EXPECT_THROW(map.step(seen_from({0, 0, std::numeric_limits<double>::quiet_NaN()})), ArgumentError);
  map.step(seen_from({0, 0, 0}, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_THROW(LocalMap(platform("scout"), telling(0.1F)), ArgumentError) << "a model for another ring";
  EXPECT_THROW(LocalMap(platform("alice"), {.name = "none", .ring = platform("alice").sonar, .evaluate = {}}),
               ArgumentError)
      << "a robot without sonars";
  LocalMapOptions fine;
  fine.fusion.view_range = 0.05;
  fine.size = 400;
  EXPECT_THROW(LocalMap(nomad(), telling(0.1F), fine), ArgumentError) << "too many views";
}

TEST(SweepMaker, SilenceIsWhatTheSonarsSayItIs) {
  SweepMaker maker(nomad().sonar, kNothing);
  Readings readings = seen_from({}, 1.5).readings;
  readings.sonar[3] = 0.7;
  SonarSweep heard = maker.sweep(readings, {});
  EXPECT_EQ(heard.range_max, kNothing);
  EXPECT_EQ(heard.ranges[0], 1.5);
  readings.sonar_max = 1.5;
  heard = maker.sweep(readings, {-0.1, 0, 0});  // went back: 0.7 + 0.1 cos
  EXPECT_EQ(heard.range_max, 1.5);
  EXPECT_EQ(heard.ranges[0], 1.5) << "no echo is not lengthened";
  EXPECT_NEAR(heard.ranges[3], 0.7 + 0.1 * std::cos(3 * kPi / 8), 1e-9);
}

TEST(SweepMaker, ReadingsOfAMovingRobotAreSeenFromWhereItIs) {
  // Between parallel walls at x = 2 and x = -2, driving along x and turning while the sonars fire one after the other.
  SweepMaker maker(nomad().sonar, kNothing);
  Readings readings;
  const Pose2 now{0.2, 0, 0.3};
  for (int i = 0; i < 16; ++i) {
    const double share = (i + 1) / 16.0;
    readings.sonar_pose.push_back({0.2 * share, 0, 0.3});
    const SinCos axis = sin_cos(wrap_angle(0.3 + 2 * kPi * i / 16));
    const double from = readings.sonar_pose.back().x + 0.23 * axis.cos;
    const double range = std::abs(axis.cos) < 0.3 ? kNothing : ((axis.cos > 0 ? 2 : -2) - from) / axis.cos;
    readings.sonar.push_back(range);
  }
  const SonarSweep sweep = maker.sweep(readings, now);
  for (std::size_t i = 0; i < 16; ++i) {
    const SinCos axis = sin_cos(wrap_angle(0.3 + 2 * kPi * static_cast<double>(i) / 16));
    if (readings.sonar[i] >= kNothing) {
      EXPECT_EQ(sweep.ranges[i], kNothing);
      continue;
    }
    const double truth = ((axis.cos > 0 ? 2 : -2) - 0.2 - 0.23 * axis.cos) / axis.cos;
    // Along the axis, not onto the wall: a fifth of the way at most is missed at the steepest axis.
    EXPECT_LT(std::abs(sweep.ranges[i] - truth), std::abs(readings.sonar[i] - truth) + 1e-9) << i;
    if (std::abs(axis.cos) > 0.95) {
      EXPECT_NEAR(sweep.ranges[i], truth, 0.02) << i;
    }
  }
}

}  // namespace
}  // namespace meander
