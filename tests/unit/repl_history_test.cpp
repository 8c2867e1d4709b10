// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/history.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "base/random.hpp"
#include "repl_pty.hpp"

namespace meander::repl {
namespace {

using Entries = std::vector<std::string>;

// Whatever is added, in whatever order: what is read again is what was there.
TEST(History, ComesBackAsItWas) {
  Stream random(7, "history");
  const std::string letters = "ab\\\n\"n ";
  for (int round = 0; round < 50; ++round) {
    const test::TemporaryFolder folder;
    History history(folder / "deep/er/history");
    for (int i = 0; i < 40; ++i) {
      std::string entry;
      for (int k = random.below(5); k >= 0; --k) entry += letters[static_cast<std::size_t>(random.below(7))];
      EXPECT_TRUE(history.add(entry));
      ASSERT_EQ(history.entries().back(), entry);
    }
    const History again(folder / "deep/er/history");
    ASSERT_EQ(again.entries(), history.entries());
    const std::set<std::string> different(again.entries().begin(), again.entries().end());
    ASSERT_EQ(different.size(), again.entries().size());
  }
}

TEST(History, KeepsTheNewest) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "history";
  {
    std::ofstream file(path);
    for (std::size_t i = 0; i < 2 * History::kMost; ++i) file << "x = " << i << '\n';
  }
  chmod(path.c_str(), 0600);
  History history(path);
  EXPECT_EQ(history.entries().size(), History::kMost);
  EXPECT_EQ(history.entries().front(), "x = " + std::to_string(History::kMost));
  history.add("one more");
  EXPECT_EQ(history.entries().size(), History::kMost);
  std::ifstream file(path);
  const auto lines = std::count(std::istreambuf_iterator<char>(file), {}, '\n');
  EXPECT_EQ(static_cast<std::size_t>(lines), History::kMost + 1);
  struct stat status {};
  stat(path.c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST(History, WorksWithoutAFile) {
  History memory("");
  EXPECT_TRUE(memory.add("a"));
  EXPECT_EQ(memory.entries(), Entries{"a"});
  History impossible("/proc/nowhere/history");
  EXPECT_FALSE(impossible.add("a"));
  EXPECT_EQ(impossible.entries(), Entries{"a"});
}

}  // namespace
}  // namespace meander::repl
