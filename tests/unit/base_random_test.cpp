// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/random.hpp"

#include <gtest/gtest.h>

#include <set>

namespace meander {
namespace {

TEST(Hash, IsTheSameOnEveryMachine) {
  EXPECT_EQ(Hash().hex(), "70d9c22c206bcc90");
  EXPECT_EQ(Hash().add(std::uint64_t{1}).hex(), "d4dad76408414a4e");
  EXPECT_EQ(Hash().add(0.1).hex(), "30813136d2cf13f2");
  EXPECT_EQ(Hash().add("meander").hex(), "933ef949e3223748");
}

TEST(Hash, OrderAndBoundariesCount) {
  EXPECT_NE(Hash().add(1.0).add(2.0).value(), Hash().add(2.0).add(1.0).value());
  EXPECT_NE(Hash().add("ab").add("c").value(), Hash().add("a").add("bc").value());
  EXPECT_NE(Hash().add("").value(), Hash().value());
  EXPECT_EQ(Hash().add(-0.0).value(), Hash().add(0.0).value());
  std::set<std::uint64_t> seen;
  for (std::uint64_t i = 0; i < 100000; ++i) seen.insert(Hash().add(i).value());
  EXPECT_EQ(seen.size(), 100000u);
}

TEST(Stream, IsTheSameOnEveryMachine) {
  Stream random(1, "golden");
  Hash hash;
  for (int i = 0; i < 1000; ++i)
    hash.add(random.uniform())
        .add(random.normal())
        .add(random.word())
        .add(static_cast<std::uint64_t>(random.below(i + 1)));
  random.add_to(hash);
  EXPECT_EQ(hash.hex(), "735619354496e02b");
}

TEST(Stream, NamesAndSeedsAreIndependent) {
  Stream a(1, "sonar"), b(1, "sonar"), c(1, "odometry"), d(2, "sonar");
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t word = a.word();
    EXPECT_EQ(word, b.word());
    EXPECT_NE(word, c.word());
    EXPECT_NE(word, d.word());
  }
}

TEST(Stream, PositionIsPartOfTheHash) {
  Stream a(1, "x"), b(1, "x");
  const auto hash = [](const Stream& s) {
    Hash h;
    s.add_to(h);
    return h.value();
  };
  EXPECT_EQ(hash(a), hash(b));
  a.word();
  EXPECT_NE(hash(a), hash(b));
  b.uniform();
  EXPECT_EQ(hash(a), hash(b));
}

TEST(Stream, DistributionsHaveTheirMoments) {
  Stream random(3, "moments");
  constexpr int kCount = 200000;
  double mean = 0, square = 0, uniform = 0;
  int hits = 0;
  std::vector<int> sides(6);
  for (int i = 0; i < kCount; ++i) {
    const double n = random.normal(2, 3), u = random.uniform(-1, 3);
    EXPECT_TRUE(u >= -1 && u < 3);
    mean += n / kCount, square += (n - 2) * (n - 2) / kCount, uniform += u / kCount;
    hits += random.chance(0.25);
    ++sides[static_cast<std::size_t>(random.below(6))];
  }
  EXPECT_NEAR(mean, 2, 0.03);
  EXPECT_NEAR(square, 9, 0.15);
  EXPECT_NEAR(uniform, 1, 0.02);
  EXPECT_NEAR(hits, kCount / 4, 1000);
  for (const int count : sides) EXPECT_NEAR(count, kCount / 6, 900);
  EXPECT_FALSE(random.chance(0));
  EXPECT_TRUE(random.chance(1));
  EXPECT_EQ(random.below(1), 0);
}

TEST(Stream, TrialSeedsDiffer) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t study = 0; study < 30; ++study)
    for (std::uint64_t trial = 0; trial < 1000; ++trial) seen.insert(trial_seed(study, trial));
  EXPECT_EQ(seen.size(), 30000u);
}

}  // namespace
}  // namespace meander
