// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The line that tells how far long work is, on a pseudo-terminal.
#include <gtest/gtest.h>

#include <sstream>

#include "repl_pty.hpp"

namespace meander::test {
namespace {

const std::map<std::string, std::string> kXterm{{"TERM", "xterm-256color"}};

/// A drive of some seconds of computing; the guide knows of nothing to reach.
const std::string kLong =
    "s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } } "
    "o = { navigator = function() return 0, 0.1 end, subgoals = { {4, 2} }, time_limit = 1e5, record_every = 0 } ";

/// The rows that such a terminal shows: a carriage return goes back to the first column.
std::vector<std::string> rows(const std::string& transcript) {
  std::vector<std::string> shown;
  std::istringstream lines(transcript);
  for (std::string line; std::getline(lines, line);) {
    std::string row;
    std::size_t column = 0;
    for (const char c : line) {
      if (c == '\r') {
        column = 0;
      } else {
        row.resize(std::max(row.size(), column + 1), ' ');
        row[column++] = c;
      }
    }
    shown.push_back(row.substr(0, row.find_last_not_of(' ') + 1));
  }
  return shown;
}

TEST(Progress, ADriveTellsHowFarItIsAndTakesTheLineAwayForOthers) {
  TemporaryFolder home;
  Terminal t(home.path(),
             program({"-e", kLong + "seen = 0 o.on_step = function(s) if s.time > seen then print('at', seen) "
                                    "seen = seen + 5000 end return s.time < 5e4 end print(s:drive(o).reason)"}),
             kXterm);
  EXPECT_EQ(t.wait_for_exit(), 0);
  EXPECT_NE(t.raw_transcript().find("driving  #"), std::string::npos) << t.raw_transcript();
  EXPECT_NE(t.raw_transcript().find("0/1 subgoals  "), std::string::npos);
  std::vector<std::string> expected;
  for (int i = 0; i <= 10; ++i) expected.push_back("at      " + std::to_string(i * 5000));
  expected.emplace_back("stopped by on_step");
  std::vector<std::string> shown = rows(t.raw_transcript());
  for (std::string& row : shown) {
    const std::size_t tab = row.find('\t');
    if (tab != std::string::npos) row.replace(tab, 1, std::string(8 - tab % 8, ' '));
    row = row.substr(0, row.find_last_not_of(' ') + 1);
  }
  EXPECT_EQ(shown, expected);
}

TEST(Progress, AnInterruptTakesTheLineAway) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"-e", kLong + "s:drive(o)"}), kXterm);
  t.wait_for("0/1 subgoals");
  t.send("\x03");
  EXPECT_EQ(t.wait_for_exit(), 130);
  for (const std::string& row : rows(t.raw_transcript())) EXPECT_EQ(row.find("driving"), std::string::npos) << row;
}

TEST(Progress, TrialsReportToo) {
  TemporaryFolder home;
  Terminal t(home.path(),
             program({"-e",
                      "local function slow() for i = 1, 3e7 do end return 1 end "
                      "print(#meander.study.trials { count = 30, jobs = 1, trial = slow })"}),
             kXterm);
  EXPECT_EQ(t.wait_for_exit(), 0);
  EXPECT_NE(t.raw_transcript().find("trials  #"), std::string::npos) << t.raw_transcript();
  EXPECT_EQ(rows(t.raw_transcript()), std::vector<std::string>{"30"});
}

TEST(Progress, NothingWithoutATerminal) {
  TemporaryFolder home;
  Terminal t(home.path(),
             shell("\"$MEANDER\" -e \"" + kLong +
                   "o.time_limit = 3e4 s:drive(o) print 'done'\" 2> err; "
                   "cat err"),
             kXterm);
  EXPECT_EQ(t.wait_for_exit(), 0);
  EXPECT_EQ(t.transcript(), "done\r\n");
}

}  // namespace
}  // namespace meander::test
