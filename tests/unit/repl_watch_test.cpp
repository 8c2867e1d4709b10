// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The live view through a pseudo-terminal: what comes, how it ends, what is left of it.
#include <gtest/gtest.h>

#include <chrono>

#include "repl_pty.hpp"

namespace meander::test {
namespace {

constexpr const char* kEnter = "\x1b[?1049h\x1b[?25l";
constexpr const char* kLeave = "\x1b[0m\x1b[?25h\x1b[?1049l";
constexpr const char* kSim =
    "s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } } "
    "o = { navigator = 'potential_field', subgoals = { {4, 2} } }";

const std::map<std::string, std::string> kColours{{"TERM", "xterm-256color"}, {"COLORTERM", "truecolor"}};

class Watch : public testing::Test {
 protected:
  Watch() : t_(home_.path(), program({"--no-rc"}), kColours) {
    t_.wait_for("> ");
    t_.enter(kSim);
  }
  /// Types a line and gives what comes up to the text.
  std::string after(const std::string& line, const std::string& text) {
    t_.send(line + "\r");
    return t_.wait_for_raw(text);
  }

  TemporaryFolder home_;
  Terminal t_;
};

TEST_F(Watch, EndsWithinATenthOfASecondWithEverythingKept) {
  after("run = watch(s, o)", "0/1 subgoals");
  t_.wait_for("clearance");
  EXPECT_FALSE(t_.is_cooked()) << "keys must not be echoed into the picture";
  const auto pressed = std::chrono::steady_clock::now();
  t_.send("\x03");
  t_.wait_for_raw(kLeave);
  const std::string left = t_.wait_for_raw("interrupted\r\n");
  const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - pressed;
  RecordProperty("milliseconds", std::to_string(waited.count()));
  EXPECT_LT(waited.count(), 100);
  const std::size_t hint = left.find("(sim:last_run() has the run so far)\r\n");
  EXPECT_LT(left.find("\xe2\x96\x80"), hint) << "the last picture stays: " << left;
  EXPECT_NE(hint, std::string::npos);
  after("print(s:last_run().reason, s.time > 0)", "interrupted\ttrue\r\n");
  after("print((s:drive(o).reason))", "all subgoals reached\r\n");
}

TEST_F(Watch, ShowsOnTheAlternateScreenAndLeavesThePicture) {
  const std::string shown = after("o.speed = 0 print(watch(s, o) == s:last_run())", "true\r\n");
  const std::size_t enter = shown.find(kEnter), leave = shown.find(kLeave);
  ASSERT_NE(enter, std::string::npos);
  ASSERT_NE(leave, std::string::npos);
  EXPECT_LT(enter, leave);
  EXPECT_NE(shown.find("\xe2\x96\x80", leave), std::string::npos) << "the last picture stays";
  t_.wait_for("> ");
}

TEST_F(Watch, AnInterruptedAnimationLeavesItsPictureToo) {
  after("meander.render.animate(function() return s end)", "Ctrl-C ends");
  t_.send("\x03");
  t_.wait_for_raw(kLeave);
  EXPECT_NE(t_.wait_for_raw("interrupted\r\n").find("\xe2\x96\x80"), std::string::npos);
}

TEST_F(Watch, TellsHowToEndItInASmallWindowToo) {
  t_.resize(8, 20);
  after("watch(s, o)", "Ctrl-C ends  ");
  t_.send("\x03");
  t_.wait_for("interrupted");
}

TEST_F(Watch, AnErrorInTheScriptLeavesTheScreenToo) {
  after("o.on_step = function(s) if s.time > 1 then error 'too late' end end o.speed = 50 watch(s, o)", kLeave);
  t_.wait_for("too late");
  t_.wait_for("> ");
  after("print(s:last_run().reason)", "stopped by an error\r\n");
}

TEST_F(Watch, ComesBackAfterCtrlZ) {
  after("watch(s, o)", "0/1 subgoals");
  t_.send("\x1a");  // a session leader is not stopped by it: it goes on at once
  t_.wait_for_raw(kLeave);
  t_.wait_for_raw(kEnter);
  t_.wait_for("subgoals");
  t_.send("\x03");
  t_.wait_for("interrupted\r\n");
  t_.wait_for("> ");
}

TEST_F(Watch, FollowsTheSizeOfTheWindow) {
  after("watch(s, o)", "0/1 subgoals");
  t_.resize(20, 60);
  t_.wait_for_raw("\x1b[2J");
  t_.wait_for_raw("\x1b[20;1H");
  t_.resize(1, 8);
  t_.wait_for_raw("\x1b[2J");
  t_.send("\x03");
  t_.wait_for("interrupted");
}

TEST_F(Watch, KilledItLeavesTheTerminalAsItWas) {
  after("watch(s, o)", "0/1 subgoals");
  t_.kill_with(15);
  EXPECT_EQ(t_.wait_for_exit(), 128 + 15);
  EXPECT_NE(t_.raw_transcript().rfind(kLeave), std::string::npos);
  EXPECT_TRUE(t_.is_cooked());
}

TEST(WatchPlain, WritesNoEscapeCodes) {
  for (const auto& environment : {std::map<std::string, std::string>{{"TERM", "dumb"}},
                                  std::map<std::string, std::string>{{"TERM", "xterm"}, {"NO_COLOR", "1"}}}) {
    TemporaryFolder home;
    Terminal t(home.path(), program({"-e", std::string(kSim) + " print(watch(s, o))"}), environment);
    EXPECT_EQ(t.wait_for_exit(), 0);
    EXPECT_NE(t.transcript().find("run: 1/1 subgoals"), std::string::npos) << t.transcript();
    EXPECT_NE(t.transcript().find("@ robot\r\n"), std::string::npos);
    EXPECT_EQ(t.raw_transcript().find('\x1b'), std::string::npos);
  }
}

TEST(WatchPlain, ReplaysARun) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"-e", std::string(kSim) + " r = s:drive(o) print(watch(r, {speed = 20}) == r)"}),
             kColours);
  EXPECT_EQ(t.wait_for_exit(), 0);
  EXPECT_NE(t.raw_transcript().find(kLeave), std::string::npos);
  EXPECT_TRUE(t.transcript().ends_with("true\r\n"));
}

}  // namespace
}  // namespace meander::test
