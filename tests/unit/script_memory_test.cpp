// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Lua's collector does not see native memory: large objects that are dropped must not pile up.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "script/bindings.hpp"
#include "script_state.hpp"

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;  // freed memory is kept in quarantine
#else
constexpr bool kSanitized = false;
#endif

namespace meander::script {
namespace {

/// Memory of this process that is in RAM [MiB].
double resident() {
  std::ifstream statm("/proc/self/statm");
  double size = 0, pages = 0;
  statm >> size >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024 * 1024);
}

class Memory : public ScriptState {
 protected:
  Memory() { bind_all(L); }

  /// How much more is resident after `count` rounds of `code`, at most over all rounds.
  double growth(int count, const std::string& code) {
    const double before = resident();
    double most = 0;
    for (int i = 0; i < count; i += 100) {
      EXPECT_EQ(run("for i = 1, 100 do " + code + " end"), "");
      most = std::max(most, resident() - before);
    }
    RecordProperty("mebibytes", std::to_string(most));
    return most;
  }
};

TEST_F(Memory, ThreeThousandLargeWorldsLeaveNothingBehind) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer keeps freed memory";
  run("large = meander.world.new { bounds = {{0, 0}, {500, 500}} }\n"
      "for i = 1, 1000 do\n"
      "  large:add_box { center = {(i % 40) * 12 + 6, (i // 40) * 12 + 6}, size = {2, 3}, heading = i }\n"
      "end");
  EXPECT_LT(growth(3000, "local copy = large:fork() copy:add_disc { center = {250, 499}, radius = 0.5 }"), 100);
}

TEST_F(Memory, ThreeThousandMatricesLeaveNothingBehind) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer keeps freed memory";
  run("rows = {} for i = 1, 100 do rows[i] = {} for j = 1, 1000 do rows[i][j] = i end end");
  EXPECT_LT(growth(3000, "local matrix = meander.matrix(rows)"), 100);
}

}  // namespace
}  // namespace meander::script
