// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/random.hpp"
#include "geometry/angle.hpp"
#include "topology/growing_net.hpp"

namespace meander::topology {
namespace {

TEST(PlaceIndex, FindsWhatACompareOfAllFinds) {
  Stream stream(1, "test");
  PlaceIndex index(0.35);
  std::map<int, Vec2> places;
  for (int step = 0; step < 5000; ++step) {
    const int cell = stream.below(300);
    const Vec2 at(stream.uniform(-4, 4), stream.uniform(-4, 4));
    if (!places.contains(cell)) {
      index.add(cell, at);
      places[cell] = at;
    } else if (stream.chance(0.5)) {
      index.move(cell, at);
      places[cell] = at;
    } else {
      index.remove(cell);
      places.erase(cell);
    }
    const double reach = stream.uniform(0, 1.5);
    std::vector<int> found;
    index.around(at, reach, [&](int c) {
      if ((places.at(c) - at).norm() <= reach) found.push_back(c);
    });
    std::sort(found.begin(), found.end());
    std::vector<int> wanted;
    for (const auto& [c, place] : places)
      if ((place - at).norm() <= reach) wanted.push_back(c);
    ASSERT_EQ(found, wanted);
  }
}

TEST(ErrorHeap, TheWorstIsOnTop) {
  Stream stream(2, "test");
  ErrorHeap heap;
  std::map<int, double> errors;
  for (int step = 0; step < 20000; ++step) {
    const int cell = stream.below(200);
    if (errors.contains(cell) && stream.chance(0.2)) {
      heap.remove(cell);
      errors.erase(cell);
    } else {
      errors[cell] = stream.below(50);
      heap.set(cell, errors[cell]);
    }
    ASSERT_EQ(heap.empty(), errors.empty());
    if (errors.empty()) continue;
    const auto worst = std::max_element(errors.begin(), errors.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
    ASSERT_EQ(heap.worst(), worst->first);
  }
}

/// A walk among places with senses that change from place to place.
struct Walk {
  explicit Walk(std::uint64_t seed) : stream(seed, "walk"), senses(48) {}
  Situation next() {
    heading += stream.normal(0, 0.3);
    const SinCos t = sin_cos(wrap_angle(heading));
    at += 0.05 * Vec2(t.cos, t.sin);
    if (at.norm() > 2.5) heading = angle_of(-at.y(), -at.x());
    for (std::size_t k = 0; k < senses.size(); ++k) {
      const SinCos wave = sin_cos(at.x() * (1 + 0.1 * static_cast<double>(k)) + at.y());
      senses[k] = static_cast<float>(0.3 * wave.sin + 0.05 * stream.normal());
    }
    return {at, senses.data()};
  }
  Stream stream;
  Vec2 at{0, 0};
  double heading = 0;
  std::vector<float> senses;
};

GrowingNet fresh_net(const NetOptions& options = {}) { return {options, SenseMetric(24, 24, Scales{}), 0.35}; }

/// Every link has two equal halves between living cells.
void expect_sound(const CellPool& cells) {
  for (int cell = 0; cell < cells.slots(); ++cell) {
    if (!cells[cell].alive()) {
      EXPECT_TRUE(cells[cell].links.empty());
      continue;
    }
    for (const Link& link : cells[cell].links) {
      ASSERT_TRUE(cells.alive(link.to));
      ASSERT_NE(link.to, cell);
      const Link* half = cells.find(link.to, cell);
      ASSERT_NE(half, nullptr);
      EXPECT_EQ(half->weight, link.weight);
      EXPECT_GT(link.weight, 0);
      EXPECT_LE(link.weight, 1);
      EXPECT_EQ(std::count_if(cells[cell].links.begin(), cells[cell].links.end(),
                              [&](const Link& other) { return other.to == link.to; }),
                1);
    }
  }
}

TEST(GrowingNet, StaysSoundWhileItGrowsAndShrinks) {
  for (const double fade : {0.05, 1.0})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      NetOptions options;
      options.fade = fade;
      options.misses_to_insert = 20;
      GrowingNet net = fresh_net(options);
      Walk walk(seed);
      for (int sample = 0; sample < 4000; ++sample) {
        const Situation situation = walk.next();
        for (int k = 0; k < 3; ++k) {
          const Match match = net.present(situation, sample);
          ASSERT_TRUE(net.cells().alive(match.cell));
          ASSERT_EQ(match.cell, net.winner());
        }
      }
      expect_sound(net.cells());
      EXPECT_GT(net.cells().size(), 20);
    }
}

TEST(GrowingNet, LooksNearAndFindsTheNearestOfAll) {
  // The bucket is as wide as a cell that may win can be far: no look at all cells would find another.
  GrowingNet net = fresh_net();
  Walk walk(7);
  const SenseMetric metric(24, 24, Scales{});
  for (int sample = 0; sample < 3000; ++sample) {
    const Situation situation = walk.next();
    double best = 1;
    int wanted = -1;
    for (int cell = 0; cell < net.cells().slots(); ++cell) {
      if (!net.cells()[cell].alive()) continue;
      const double d = (net.cells()[cell].position - situation.position).squaredNorm() / (0.35 * 0.35) +
                       metric.squared(net.cells().senses(cell), situation.senses);
      if (d < best) {
        best = d;
        wanted = cell;
      }
    }
    const auto match = net.nearest(situation);
    ASSERT_EQ(match ? match->cell : -1, wanted);
    if (match) {
      ASSERT_NEAR(match->distance, std::sqrt(best), 1e-9);
    }
    net.present(situation, sample);
  }
}

TEST(GrowingNet, TheWinnerMovesByItsRateAndAHitLowersIt) {
  GrowingNet net = fresh_net();
  std::vector<float> senses(48, 0.0f);
  const int cell = net.present({{0, 0}, senses.data()}, 0).cell;
  EXPECT_EQ(net.present({{0.1, 0}, senses.data()}, 1).cell, cell);  // a hit at the full rate of a miss
  EXPECT_NEAR(net.cells()[cell].position.x(), 0.02 * 0.1, 1e-12);
  EXPECT_NEAR(net.rate(), 0.02 * 0.9, 1e-12);
  EXPECT_EQ(net.present({{0.32, 0}, senses.data()}, 2).cell, cell);  // a miss that is near enough
  EXPECT_EQ(net.rate(), 0.02);
  EXPECT_NE(net.present({{0.6, 0}, senses.data()}, 3).cell, cell);
  EXPECT_EQ(net.cells().size(), 2);
  EXPECT_NE(net.cells().find(cell, net.winner()), nullptr);
}

TEST(GrowingNet, LinksThatAreNotDrivenFadeWhenTheirCellWins) {
  // Three cells in a row, driven to and fro between the first two: the link to the third goes after 1 / fade wins.
  NetOptions options;
  options.fade = 0.25;
  options.least_component = 0;
  options.misses_to_insert = 0;
  GrowingNet net = fresh_net(options);
  std::vector<float> senses(48, 0.0f);
  const auto at = [&](double x) { return net.present({{x, 0}, senses.data()}, 0).cell; };
  const int a = at(0), b = at(0.5), c = at(1.0);
  ASSERT_NE(net.cells().find(b, c), nullptr);
  at(0.5);
  int wins = 0;
  while (net.cells().find(b, c) && wins < 100) {
    EXPECT_EQ(at(0), a);
    EXPECT_EQ(at(0.5), b);
    ++wins;
  }
  EXPECT_EQ(wins, 4);
  EXPECT_TRUE(net.cells().alive(c));
}

TEST(GrowingNet, ACellPutIntoALinkKeepsWhatSpeaksAgainstIt) {
  NetOptions options;
  options.misses_to_insert = 4;
  GrowingNet net = fresh_net(options);
  std::vector<float> senses(48, 0.0f);
  const auto at = [&](double x) { return net.present({{x, 0}, senses.data()}, 0).cell; };
  const int a = at(0), b = at(0.5);
  EXPECT_EQ(at(-0.32), a);
  net.cells().connect(a, b, {.doubt = 3, .suspended = true});
  EXPECT_EQ(at(-0.33), a);  // the fourth miss
  ASSERT_EQ(net.cells().size(), 3);
  EXPECT_EQ(net.cells().find(a, b), nullptr);
  for (const int end : {a, b}) {
    ASSERT_EQ(net.cells()[end].links.size(), 1u);
    EXPECT_TRUE(net.cells()[end].links[0].suspended);
    EXPECT_EQ(net.cells()[end].links[0].doubt, 3);
    EXPECT_EQ(net.cells()[end].links[0].weight, 1);
  }
}

TEST(Senses, RingsTurnThereAndBack) {
  std::vector<float> ring{1, 0, 0, 2, 0, 5}, out(6), back(6);
  turn_ring(ring, kPi / 3, out);
  EXPECT_FLOAT_EQ(out[2], 2);
  turn_ring(out, -kPi / 3, back);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(back[i], ring[i], 1e-6);
  turn_ring(ring, -7 * kPi / 6, out);  // half a pitch and three whole ones
  EXPECT_NEAR(out[0], 1.0, 1e-6);
}

TEST(Senses, SmoothedContactsAddUpToWhatIsBent) {
  const TouchSmoother smoother(24, radians(20));
  std::vector<std::uint8_t> bent(24);
  bent[0] = bent[1] = bent[23] = 1;
  std::vector<float> out(24);
  smoother.smooth(bent, out);
  double sum = 0;
  for (const float value : out) sum += static_cast<double>(value);
  EXPECT_NEAR(sum, 3, 1e-5);
  EXPECT_GT(out[0], out[1]);
  EXPECT_FLOAT_EQ(out[1], out[23]);
}

}  // namespace
}  // namespace meander::topology
