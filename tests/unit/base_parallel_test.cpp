// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/random.hpp"

namespace meander {
namespace {

/// Work of very different length per item, so that later items finish first.
std::uint64_t uneven(std::size_t i) {
  Stream random(i, "uneven");
  std::uint64_t sum = 0;
  for (int k = 0; k < 1 + static_cast<int>(i * 7919 % 5) * 4000; ++k) sum += random.word();
  return sum;
}

std::vector<std::uint64_t> run(std::size_t count, int threads) {
  std::vector<std::uint64_t> results;
  ordered_parallel(count, threads, {}, uneven, [&](std::size_t i, std::uint64_t result) {
    EXPECT_EQ(i, results.size());
    results.push_back(result);
  });
  return results;
}

TEST(OrderedParallel, KeepsTheOrderWithAnyNumberOfThreads) {
  const std::vector<std::uint64_t> alone = run(200, 1);
  ASSERT_EQ(alone.size(), 200u);
  for (const int threads : {2, 3, 8, 0}) EXPECT_EQ(run(200, threads), alone);
  EXPECT_TRUE(run(0, 4).empty());
}

TEST(OrderedParallel, TakesOneAtATime) {
  std::atomic<int> inside{0};
  int most = 0;
  ordered_parallel(
      500, 4, {}, [](std::size_t i) { return i; },
      [&](std::size_t, std::size_t) {
        most = std::max(most, ++inside);
        --inside;
      });
  EXPECT_EQ(most, 1);
}

TEST(OrderedParallel, AnExceptionEndsTheLoopAndComesThrough) {
  for (const int threads : {1, 4}) {
    std::size_t taken = 0;
    const auto make = [](std::size_t i) -> std::size_t {
      if (i == 20) throw std::runtime_error("twenty");
      return i;
    };
    try {
      ordered_parallel(100000, threads, {}, make, [&](std::size_t, std::size_t) { ++taken; });
      FAIL() << "no exception";
    } catch (const std::runtime_error& e) {
      EXPECT_STREQ(e.what(), "twenty");
    }
    EXPECT_LE(taken, 20u);
    EXPECT_THROW(ordered_parallel(9, threads, {}, uneven, [](std::size_t, std::uint64_t) { throw FileError("full"); }),
                 FileError);
  }
}

TEST(OrderedParallel, AStopIsSeenSoonAndIsNoStdException) {
  for (const int threads : {1, 4}) {
    StopToken stop;
    std::size_t taken = 0;
    const auto take = [&](std::size_t i, std::uint64_t) {
      ++taken;
      if (i == 10) stop.request();
    };
    EXPECT_THROW(ordered_parallel(1'000'000, threads, {.stop = &stop, .progress = {}}, uneven, take), Cancelled);
    EXPECT_LT(taken, 200u);
    stop.clear();
    EXPECT_NO_THROW(Work({.stop = &stop, .progress = {}}).poll());
  }
}

TEST(OrderedParallel, ReportsProgressUpToOne) {
  double last = 0;
  const Work work{.stop = nullptr, .progress = [&](double fraction, std::string_view) {
                    EXPECT_GT(fraction, last);
                    last = fraction;
                  }};
  ordered_parallel(50, 3, work, uneven, [](std::size_t, std::uint64_t) {});
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace meander
