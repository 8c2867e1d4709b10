// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/trials.hpp"

#include <dirent.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace meander {
namespace {

int open_descriptors() {
  int count = 0;
  DIR* folder = opendir("/proc/self/fd");
  while (readdir(folder)) ++count;
  closedir(folder);
  return count;
}

/// Whatever a test does: no process and no descriptor may be left.
class Trials : public testing::Test {
 protected:
  void SetUp() override { before_ = open_descriptors(); }
  void TearDown() override {
    EXPECT_EQ(open_descriptors(), before_);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  }

 private:
  int before_ = 0;
};

std::vector<TrialResult> run(std::size_t count, int jobs, const std::function<std::string(std::size_t)>& trial) {
  std::vector<TrialResult> results;
  run_trials(count, jobs, {}, trial, [&](const TrialResult& result) { results.push_back(result); });
  return results;
}

void work_a_little(std::size_t milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

TEST_F(Trials, EveryResultOnceAndInOrderForAnyNumberOfJobs) {
  const auto trial = [](std::size_t i) {
    work_a_little((i * 7) % 5);  // finishes out of order
    return "result " + std::to_string(i * i);
  };
  for (const int jobs : {0, 1, 2, 7}) {
    const auto results = run(23, jobs, trial);
    ASSERT_EQ(results.size(), 23u);
    for (std::size_t i = 0; i < results.size(); ++i) {
      EXPECT_EQ(results[i].index, i);
      EXPECT_TRUE(results[i].ok);
      EXPECT_EQ(results[i].text, trial(i));
    }
  }
  EXPECT_TRUE(run(0, 3, trial).empty());
}

TEST_F(Trials, LargeAndEmptyResultsArriveWhole) {
  const auto trial = [](std::size_t i) { return std::string(i * 1'000'003, static_cast<char>('a' + i)); };
  const auto results = run(5, 2, trial);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(results[i].text, trial(i));
}

TEST_F(Trials, CrashesExitsAndExceptionsCostOneTrialEach) {
  const auto results = run(12, 3, [](std::size_t i) -> std::string {
    if (i == 2) std::raise(SIGKILL);
    if (i == 3) throw std::runtime_error("no route");
    if (i == 5) _exit(3);
    if (i == 7) std::raise(SIGKILL);
    return "fine";
  });
  ASSERT_EQ(results.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    const bool bad = i == 2 || i == 3 || i == 5 || i == 7;
    EXPECT_EQ(results[i].ok, !bad) << i;
    if (!bad) {
      EXPECT_EQ(results[i].text, "fine");
    }
  }
  EXPECT_EQ(results[2].text, "the worker process crashed: signal 9 (Killed)");
  EXPECT_EQ(results[3].text, "no route");
  EXPECT_EQ(results[5].text, "the worker process ended with exit code 3");
}

TEST_F(Trials, EveryTrialMayCrash) {
  const auto results = run(9, 2, [](std::size_t) -> std::string {
    std::raise(SIGKILL);
    return {};
  });
  ASSERT_EQ(results.size(), 9u);
  for (const TrialResult& result : results) EXPECT_FALSE(result.ok);
}

TEST_F(Trials, NothingCarriesOverFromTrialToTrial) {
  for (const int jobs : {1, 2, 5}) {
    int state = 0;
    const auto results = run(12, jobs, [&](std::size_t i) -> std::string {
      state += static_cast<int>(i) + 1;
      if (i == 4) throw std::runtime_error("no route");
      return std::to_string(state);
    });
    EXPECT_EQ(state, 0);
    for (std::size_t i = 0; i < results.size(); ++i)
      EXPECT_EQ(results[i].text, i == 4 ? "no route" : std::to_string(i + 1)) << jobs;
  }
}

TEST_F(Trials, NothingLeavesTheChildWhateverIsThrown) {
  const pid_t parent = getpid();
  for (const int jobs : {1, 2}) {
    std::vector<TrialResult> results;
    try {
      results = run(3, jobs, [](std::size_t i) -> std::string {
        if (i == 1) throw 42;
        return {};
      });
    } catch (int) {
    }
    if (getpid() != parent) _exit(9);
    ASSERT_EQ(results.size(), 3u);
    EXPECT_EQ(results[1].text, "the worker process ended with exit code 70");
    EXPECT_TRUE(results[2].ok);
  }
}

/// No more than `more` further descriptors while it lives: what a machine does that is short of them, or of processes.
class FewDescriptors {
 public:
  explicit FewDescriptors(int more) {
    const int next = dup(0);
    close(next);
    getrlimit(RLIMIT_NOFILE, &before_);
    rlimit few = before_;
    few.rlim_cur = static_cast<rlim_t>(next + more);
    setrlimit(RLIMIT_NOFILE, &few);
  }
  ~FewDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_;
};

/// UBSan's vptr check opens a pipe to see whether memory may be read, and takes the missing descriptor for a bad
/// object.
#ifdef __SANITIZE_ADDRESS__
#define SKIP_WITHOUT_DESCRIPTORS GTEST_SKIP() << "the sanitizers need descriptors of their own"
#else
#define SKIP_WITHOUT_DESCRIPTORS static_cast<void>(0)
#endif

TEST_F(Trials, AShortageLowersTheNumberOfJobs) {
  SKIP_WITHOUT_DESCRIPTORS;
  const FewDescriptors few(4);
  const auto results = run(20, 8, [](std::size_t i) {
    work_a_little(5);
    return std::to_string(i);
  });
  ASSERT_EQ(results.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(results[i].text, std::to_string(i));
}

TEST_F(Trials, WithoutAnyProcessTheReasonIsNamed) {
  SKIP_WITHOUT_DESCRIPTORS;
  const FewDescriptors few(1);
  try {
    run(3, 2, [](std::size_t) { return std::string(); });
    FAIL() << "an error expected";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "cannot start a worker process: Too many open files");
  }
}

TEST_F(Trials, AStopKillsHangingWorkersQuickly) {
  StopToken stop;
  std::jthread later([&] {
    work_a_little(200);
    stop.request();
  });
  int taken = 0;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THROW(run_trials(
                   6, 2, {&stop, {}},
                   [](std::size_t i) -> std::string {
                     while (i == 1) work_a_little(10);  // hangs
                     return {};
                   },
                   [&](const TrialResult&) { ++taken; }),
               Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
  EXPECT_EQ(taken, 1) << "results behind the hanging one must wait for it";
}

TEST_F(Trials, AnExceptionOfTheTakerEndsTheStudy) {
  EXPECT_THROW(run_trials(
                   50, 3, {}, [](std::size_t) { return std::string(); },
                   [](const TrialResult& result) {
                     if (result.index == 4) throw std::runtime_error("disk full");
                   }),
               std::runtime_error);
}

TEST_F(Trials, ProgressIsReportedToTheEnd) {
  double last = 0;
  const Work work{nullptr, [&](double fraction, std::string_view) {
                    EXPECT_GE(fraction, last);
                    last = fraction;
                  }};
  run_trials(
      10, 2, work, [](std::size_t) { return std::string(); }, [](const TrialResult&) {});
  EXPECT_EQ(last, 1);
}

TEST_F(Trials, WhatATrialPrintsComesOnce) {
  testing::internal::CaptureStdout();
  std::printf("before ");
  run(2, 2, [](std::size_t) {
    std::printf("trial ");
    return std::string();
  });
  std::printf("after");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "before trial trial after");
}

TEST_F(Trials, NegativeJobsAreRefused) {
  EXPECT_THROW(run(1, -1, [](std::size_t) { return std::string(); }), ArgumentError);
}

}  // namespace
}  // namespace meander
