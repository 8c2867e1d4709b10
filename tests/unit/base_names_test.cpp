// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/names.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace meander {
namespace {

const std::vector<std::string> kKnown{"half_cone", "range_min", "range_max", "noise", "bounce"};

TEST(Names, FindsTheNearest) {
  EXPECT_EQ(nearest_name("half_cnoe", kKnown), "half_cone");
  EXPECT_EQ(nearest_name("noize", kKnown), "noise");
  EXPECT_EQ(nearest_name("bonce", kKnown), "bounce");
  EXPECT_EQ(nearest_name("range_mx", kKnown), "range_max");
  EXPECT_EQ(nearest_name("noise", kKnown), "noise");
  EXPECT_EQ(nearest_name("zzz", kKnown), std::nullopt);
  EXPECT_EQ(nearest_name("", kKnown), std::nullopt);
  EXPECT_EQ(nearest_name("x", {}), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'a'), kKnown), std::nullopt);
}

TEST(Names, ShortWordsAreNearToFew) {
  EXPECT_EQ(nearest_name("-", {"g", "a"}), std::nullopt);
  EXPECT_EQ(nearest_name("ab", {"a", "xb"}), std::nullopt);
  EXPECT_EQ(nearest_name("ab", {"abc"}), "abc");
  EXPECT_EQ(nearest_name("goal", {"goal_1", "g"}), "goal_1");
  EXPECT_EQ(nearest_name("crat", {"crates_left", "door"}), "crates_left");
  EXPECT_EQ(nearest_name("hal", {"hall_south_1", "hall"}), "hall");
  EXPECT_EQ(nearest_name("nomod", {"json", "report"}), std::nullopt);
}

TEST(Names, OneSlipIsAlwaysForgiven) {
  Stream random(1, "slips");
  for (int i = 0; i < 2000; ++i) {
    const std::string& name = kKnown[static_cast<std::size_t>(random.below(5))];
    std::string slip = name;
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(name.size()) - 1));
    switch (random.below(4)) {
      case 0:
        slip.erase(at, 1);
        break;
      case 1:
        slip.insert(at, 1, 'q');
        break;
      case 2:
        slip[at] = 'q';
        break;
      default:
        std::swap(slip[at], slip[at + 1]);
    }
    const auto found = nearest_name(slip, kKnown);
    ASSERT_TRUE(found) << slip;
    EXPECT_TRUE(*found == name || name.starts_with("range_m")) << slip;
  }
}

TEST(Names, Wording) {
  EXPECT_EQ(did_you_mean("noize", kKnown), "; did you mean 'noise'?");
  EXPECT_EQ(did_you_mean("zzz", kKnown), "");
  EXPECT_EQ(listing({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(listing({"a", "b", "c"}, 2), "a, b, ...");
  EXPECT_EQ(listing({}), "");
}

}  // namespace
}  // namespace meander
