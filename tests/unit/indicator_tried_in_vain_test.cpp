// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/tried_in_vain.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace meander {
namespace {

std::vector<float> evidence_of(const SonarOccupancy& map) { return map.memory().evidence.cells(); }

TEST(TriedInVain, IsWeakTheFirstTimeAndCertainTheSecond) {
  SonarOccupancy map(platform("nomad200"));
  map.include({0, 0});
  TriedInVain tried;
  const Cell ahead = map.space().frame().cell({map.reach() + 0.05, 0});
  tried.stop(map, {0, 0}, {1, 0});
  EXPECT_TRUE(map.weak(ahead));
  tried.stop(map, {0.1, 0}, {1, 0});
  tried.stop(map, {0, 0}, {1, 0});
  EXPECT_EQ(map.space().known(ahead), Known::wall);
  EXPECT_FALSE(map.weak(ahead));
}

TEST(TriedInVain, TakenBackTheMapIsAsItWasAndNothingIsLeftToTakeBack) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Stream random(seed, "tried in vain");
    const auto place = [&] { return Vec2(random.uniform(-2, 2), random.uniform(-2, 2)); };
    SonarOccupancy map(platform("nomad200"));
    map.include({0, 0});
    for (int i = 0; i < 3000; ++i) map.add(map.space().frame().cell(place()), random.uniform(-12, 12));
    const std::vector<float> before = evidence_of(map);
    TriedInVain tried;
    EXPECT_FALSE(tried.take_back(map));
    for (int i = 0; i < 12; ++i) tried.stop(map, place(), place());
    EXPECT_NE(evidence_of(map), before);
    const std::string text = tried.lines();
    TextLines lines(text, "text");
    TriedInVain read;
    read.read(lines);
    EXPECT_EQ(read.lines(), text);
    EXPECT_TRUE(read.take_back(map));
    const std::vector<float> after = evidence_of(map);
    for (std::size_t i = 0; i < before.size(); ++i) ASSERT_NEAR(after[i], before[i], 1e-5) << seed;
    EXPECT_FALSE(read.take_back(map));
  }
}

}  // namespace
}  // namespace meander
