// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// What outlives an input: the history, the start-up file, scripts loaded, saved and edited.
#include <algorithm>

#include "repl_at_prompt.hpp"

namespace meander::test {
namespace {

using SessionFiles = AtPrompt;
TEST_P(SessionFiles, ASavedSessionDeclaresWhatOnlyThePromptTakes) {
  t.enter("function count() counted = (rawget(_G, 'counted') or 0) + 1 return counted end");
  t.enter("count()");
  t.enter("w = world.new {}");
  t.enter(".save all.lua");
  EXPECT_TRUE(file_text("all.lua").starts_with("counted = nil\nworld = meander.world\n")) << file_text("all.lua");
  EXPECT_EQ(t.enter(".load all.lua"), "");
  EXPECT_EQ(t.enter("counted"), "1\r\n");
}

INSTANTIATE_TEST_SUITE_P(, SessionFiles, testing::ValuesIn(kTerminals), terminal_name);

constexpr const char* kHistory = ".local/state/meander/history";

TEST_P(SessionFiles, HistoryPersistsWithoutDuplicates) {
  t.enter("kept = 'once'");
  t.enter("function two()");
  t.enter("return 2 end");
  t.enter("kept = 'once'");
  t.send("\x04");
  EXPECT_EQ(t.wait_for_exit(), 0);
  EXPECT_EQ(file_text(kHistory), "kept = 'once'\nfunction two()\\nreturn 2 end\nkept = 'once'\n");
  struct stat status {};
  ASSERT_EQ(stat((home / kHistory).c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);

  Terminal again(home.path(), program({"--no-rc"}), environment());
  again.wait_for("> ");
  again.send("\x10");  // Ctrl-P, as the arrow up
  again.wait_for("kept = 'once'");
  again.enter("");
  EXPECT_EQ(again.enter("kept"), "\"once\"\r\n");
  again.send("\x10\x10\x10\r");  // the function, both lines of it at once
  again.wait_for("\r\n> ");
  EXPECT_EQ(again.enter("two()"), "2\r\n");
}

TEST_P(SessionFiles, HistoryIsSearched) {
  t.enter("needle = 41");
  t.enter("straw = 1");
  t.send(
      "\x12"
      "need");  // Ctrl-R
  t.wait_for("needle = 41");
  t.send("\x05 + 1\r");  // Ctrl-E ends the search at the end of the line
  t.wait_for("\r\n> ");
  EXPECT_EQ(t.enter("needle"), "42\r\n");
}

TEST_P(SessionFiles, TwoSessionsShareTheHistory) {
  Terminal other(home.path(), program({"--no-rc"}), environment());
  other.wait_for("> ");
  for (int i = 0; i < 20; ++i) {
    t.enter("mine = " + std::to_string(i));
    other.enter("other = " + std::to_string(i));
  }
  const std::string entries = file_text(kHistory);
  EXPECT_EQ(std::count(entries.begin(), entries.end(), '\n'), 40);
}

TEST_P(SessionFiles, StartUpFileRuns) {
  write_file("init.lua", "print 'not this one'");
  ASSERT_EQ(mkdir((home / "meander").c_str(), 0700), 0);
  write_file("meander/init.lua", "greeting = 'from init.lua' error 'and an error'");
  auto with_config = environment();
  with_config["XDG_CONFIG_HOME"] = home.path();
  Terminal started(home.path(), program(), with_config);
  started.wait_for("and an error\r\n");
  started.wait_for("> ");
  EXPECT_EQ(started.enter("greeting"), "\"from init.lua\"\r\n");
  Terminal bare(home.path(), program({"--no-rc"}), with_config);
  bare.wait_for("> ");
  EXPECT_EQ(bare.enter("rawget(_G, 'greeting')"), "nil\r\n");
}

TEST_P(SessionFiles, ScriptsAreLoadedAndSaved) {
  write_file("part.lua", "part = 7 print('part runs')");
  EXPECT_EQ(t.enter(".load part.lua"), "part runs\r\n");
  EXPECT_EQ(t.enter("part * 2"), "14\r\n");
  EXPECT_EQ(t.enter("between = 1"), "");
  EXPECT_EQ(t.enter("twice = _"), "");
  EXPECT_EQ(t.enter("_"), "14\r\n");
  EXPECT_EQ(t.enter("nosuch.thing"), "undeclared variable 'nosuch'\r\n");
  EXPECT_NE(t.enter("help(deg)"), "");
  EXPECT_EQ(t.enter("world.new {}:names()"), "{}\r\n");
  t.send("print 'begun' while true do end\r");
  t.wait_for("begun\r\n");
  t.send("\x03");
  t.wait_for("interrupted\r\n> ");
  EXPECT_EQ(t.enter(".save part.lua"), "'part.lua' exists already; choose another name\r\n");
  EXPECT_EQ(t.enter(".save all.lua"), "saved as 'all.lua' (1 interrupted input left out; results may differ)\r\n");
  EXPECT_EQ(file_text("all.lua"),
            "world = meander.world\ndofile(\"part.lua\")\n_ = part * 2\nprint(_)\nbetween = 1\ntwice = _\nprint(_)\n"
            "world.new {}:names()\n-- interrupted, left out; results may differ: print 'begun' while true do end\n");
  Terminal again(home.path(), program({"-i", "--no-rc", "all.lua"}), environment());
  again.wait_for("> ");
  EXPECT_EQ(again.enter("twice"), "14\r\n");
}

TEST_P(SessionFiles, APromptMayFollowAScript) {
  write_file("script.lua", "value = #arg");
  Terminal after(home.path(), program({"-i", "--no-rc", "script.lua", "a", "b"}), environment());
  after.wait_for("> ");
  EXPECT_EQ(after.enter("value"), "2\r\n");
}

TEST_P(SessionFiles, QuitLeaves) {
  t.send(".quit\r");
  EXPECT_EQ(t.wait_for_exit(), 0);
}

}  // namespace
}  // namespace meander::test
