// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/child_process.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "base/error.hpp"

namespace meander {
namespace {

using Surroundings = ChildProcess::Surroundings;

struct End {
  ChildResult result;
  std::string output;
};

End wait_for(ChildProcess& child) {
  End end;
  for (;;) {
    pollfd open[] = {{child.descriptor(), POLLIN, 0}, {child.output_descriptor(), POLLIN, 0}};
    poll(open, 2, 20);
    end.output += child.take_output();
    if (auto result = child.receive()) {
      end.result = std::move(*result);
      end.output += child.take_output();
      return end;
    }
  }
}

End run(const std::function<std::string()>& work, Surroundings surroundings = Surroundings::own) {
  ChildProcess child(work, {}, surroundings);
  return wait_for(child);
}

TEST(ChildProcess, GivesBytesOfAnySize) {
  for (const std::size_t size : {0u, 1u, 3'000'000u})
    for (const auto surroundings : {Surroundings::own, Surroundings::shared}) {
      const End end = run([&] { return std::string(size, '\0'); }, surroundings);
      EXPECT_TRUE(end.result.ok);
      EXPECT_EQ(end.result.text.size(), size);
    }
}

TEST(ChildProcess, TellsWhatWentWrong) {
  const End thrown = run([]() -> std::string { fail<Error>("no {}", "luck"); });
  EXPECT_FALSE(thrown.result.ok);
  EXPECT_FALSE(thrown.result.died);
  EXPECT_EQ(thrown.result.text, "no luck");
  const End left = run([]() -> std::string { _exit(3); });
  EXPECT_TRUE(left.result.died);
  EXPECT_EQ(left.result.text, "the worker process ended with exit code 3");
  const End killed = run([]() -> std::string { return raise(SIGKILL) ? "" : ""; });
  EXPECT_TRUE(killed.result.died);
  EXPECT_NE(killed.result.text.find("signal 9"), std::string::npos);
}

TEST(ChildProcess, KeepsTheOrderOfWhatItWrites) {
  const End end = run([] {
    std::puts("one");
    std::fputs("two\n", stderr);
    std::fputs("three", stdout);
    return std::string();
  });
  EXPECT_EQ(end.output, "one\ntwo\nthree");
}

TEST(ChildProcess, IsNotHeldUpByWhatItLeavesBehind) {
  const End end = run([]() -> std::string {
    if (fork() == 0) {
      for (;;) pause();  // holds both ends open
    }
    _exit(0);
  });
  EXPECT_TRUE(end.result.died);
}

TEST(ChildProcess, CanBeInterruptedAndKilled) {
  for (const bool softly : {true, false}) {
    ChildProcess child(
        []() -> std::string {
          for (;;) pause();
        },
        {}, Surroundings::own);
    if (softly)
      child.interrupt();
    else
      child.kill();
    EXPECT_TRUE(wait_for(child).result.died);
  }
}

TEST(ChildProcess, ClosesWhatBelongsToOthers) {
  ChildProcess first([] { return std::string("first"); }, {});
  const std::vector<int> others{first.descriptor()};
  ChildProcess second([&] { return std::string(write(others[0], "", 0) < 0 ? "closed" : "open"); }, others);
  EXPECT_EQ(wait_for(second).result.text, "closed");
  EXPECT_EQ(wait_for(first).result.text, "first");
}

}  // namespace
}  // namespace meander
