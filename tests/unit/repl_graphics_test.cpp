// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The question what graphics a terminal understands, with a test at the other end that answers like one.
#include <gtest/gtest.h>

#include <chrono>

#include "render/terminal_caps.hpp"
#include "repl_pty.hpp"

namespace meander::test {
namespace {

constexpr const char* kShow = "print 'asking' show(meander.world.new {}) print 'shown'";
const std::map<std::string, std::string> kXterm{{"TERM", "xterm-256color"}, {"TMUX", ""}, {"STY", ""}};

/// What the program writes between the answer to its question and the end of show().
std::string shown_after(Terminal& t, const std::string& answer) {
  t.wait_for_raw("> ");
  t.send(std::string(kShow) + "\r");
  t.wait_for_raw(kGraphicsQuery);
  t.send(answer);
  return t.wait_for_raw("shown\r\n");
}

TEST(Graphics, ATerminalLikeKittyGetsPng) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"--no-rc"}), kXterm);
  EXPECT_NE(shown_after(t, "\x1b_Gi=31;OK\x1b\\\x1b[?62;c").find("\x1b_Ga=T,f=100,"), std::string::npos);
}

TEST(Graphics, ATerminalWithSixelGetsThem) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"--no-rc"}), kXterm);
  EXPECT_NE(shown_after(t, "\x1b[?62;4;22c").find("\x1bP0;1;0q"), std::string::npos);
  t.send(std::string(kShow) + "\r");
  EXPECT_EQ(t.wait_for_raw("shown\r\n").find(kGraphicsQuery), std::string::npos) << "asked once";
}

TEST(Graphics, ATerminalWithoutEitherGetsCharacters) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"--no-rc"}), kXterm);
  const std::string shown = shown_after(t, "\x1b[?64;1;2c");
  EXPECT_NE(shown.find("\xe2\x96\x80"), std::string::npos);
  EXPECT_EQ(shown.find("64;1;2"), std::string::npos) << "answers are not echoed";
}

TEST(Graphics, NoAnswerIsWaitedForShortlyAndKeysAreKept) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"--no-rc"}), kXterm);
  t.wait_for_raw("> ");
  t.send(std::string(kShow) + "\r");
  t.wait_for_raw(kGraphicsQuery);
  const auto asked = std::chrono::steady_clock::now();
  t.send("print(6 * 7)\r");
  EXPECT_NE(t.wait_for_raw("shown\r\n").find("\xe2\x96\x80"), std::string::npos);
  const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - asked;
  EXPECT_GT(waited.count(), 100);
  EXPECT_LT(waited.count(), 1000) << "150 ms and the picture";
  t.wait_for_raw("print(6 * 7)");
  t.wait_for_raw("42\r\n");
}

TEST(Graphics, AnAnswerThatComesLateIsNotTyped) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"--no-rc"}), kXterm);
  EXPECT_NE(shown_after(t, "").find("\xe2\x96\x80"), std::string::npos);
  t.wait_for_raw("> ");
  t.send("6 *\x1b_Gi=31;ENO");
  t.wait_for_raw("6 *");
  t.send("TSUP\x1b\\\x1b[?62;4c 7\r");
  const std::string after = t.wait_for_raw("42\r\n");
  EXPECT_EQ(after.find("62;4"), std::string::npos) << after;
  EXPECT_EQ(after.find("TSUP"), std::string::npos) << after;
  t.send(std::string(kShow) + "\r");
  EXPECT_NE(t.wait_for_raw("shown\r\n").find("\x1bP0;1;0q"), std::string::npos) << "it counts from then on";
}

TEST(Graphics, KeysAmongTheAnswersAreKept) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"--no-rc"}), kXterm);
  const std::string shown = shown_after(t, "print(6\x1b[?62;4c");
  EXPECT_NE(shown.find("\x1bP0;1;0q"), std::string::npos);
  t.send(" * 7)\r");
  t.wait_for_raw("42\r\n");
}

TEST(Graphics, ScriptsReadTheirInputWhole) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"-e", std::string(kShow) + " print('<' .. io.read() .. '>')"}), kXterm);
  t.wait_for_raw(kGraphicsQuery);
  t.send("he\x1b[?62;4cllo\r");
  t.wait_for_raw("shown\r\n");
  t.wait_for_raw("<hello>\r\n");
}

TEST(Graphics, NothingIsAskedInTmuxOrWhereTheUserHasDecided) {
  using Environment = std::map<std::string, std::string>;
  for (const Environment& more : {Environment{{"TMUX", "/tmp/tmux,1,0"}}, Environment{{"MEANDER_GRAPHICS", "half"}},
                                  Environment{{"TERM", "linux"}}, Environment{{"NO_COLOR", "1"}}}) {
    Environment environment = kXterm;
    for (const auto& [name, value] : more) environment[name] = value;
    TemporaryFolder home;
    Terminal t(home.path(), program({"-e", kShow}), environment);
    EXPECT_EQ(t.wait_for_exit(), 0);
    EXPECT_EQ(t.raw_transcript().find("\x1b_G"), std::string::npos);
    EXPECT_EQ(t.raw_transcript().find("\x1b[c"), std::string::npos);
  }
}

TEST(Graphics, NoneShowsNothing) {
  TemporaryFolder home;
  Terminal t(home.path(), program({"-e", kShow}), {{"TERM", "xterm"}, {"MEANDER_GRAPHICS", "none"}});
  EXPECT_EQ(t.wait_for_exit(), 0);
  EXPECT_EQ(t.transcript(), "asking\r\nshown\r\n");
}

}  // namespace
}  // namespace meander::test
