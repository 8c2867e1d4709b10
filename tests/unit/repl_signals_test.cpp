// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The terminal and what happens to it: signals, sizes, closing, pipes.
#include <csignal>

#include "repl_at_prompt.hpp"

namespace meander::test {
namespace {

using Signals = AtPrompt;
INSTANTIATE_TEST_SUITE_P(, Signals, testing::ValuesIn(kTerminals), terminal_name);

TEST_P(Signals, EndOfInputInAContinuationLeavesNoTrace) {
  t.send("f(\r");
  t.wait_for(">> ");
  t.send("\x04");
  t.wait_for("<eof>\r\n> ");
  EXPECT_EQ(t.enter("print 'one'"), "one\r\n");
}

/// What `stty -a` says before and after must be the same.
TEST_P(Signals, EveryWayOutRestoresTheTerminal) {
  const struct {
    const char* typed;
    const char* code;
  } ways[] = {{"\x04", "0"}, {".quit\r", "0"}, {"os.exit(4)\r", "4"}, {"os.execute('kill -TERM ' .. pid())\r", "143"}};
  for (const auto& way : ways) {
    Terminal session(home.path(),
                     shell("stty -a > before; $MEANDER --no-rc; echo code $?; stty -a > after; cmp before after"),
                     environment());
    session.wait_for("> ");
    session.enter("function pid() return io.open('/proc/self/stat'):read('n') end");
    session.send(way.typed);
    session.wait_for(std::string("code ") + way.code);
    EXPECT_EQ(session.wait_for_exit(), 0) << way.typed;
  }
}

TEST_P(Signals, TerminationAtThePromptRestoresTheTerminal) {
  Terminal session(home.path(), shell("stty -a > before; $MEANDER --no-rc; echo code $?; stty -a > after"),
                   environment());
  session.wait_for("> ");
  kill(std::stoi(session.enter("io.open('/proc/self/stat'):read('n')")), SIGTERM);
  session.wait_for("code 143");
  session.wait_for_exit();
  EXPECT_EQ(file_text("before"), file_text("after"));
}

TEST_P(Signals, StopsAndContinues) {
  Terminal bash(home.path(), other_program({"bash", "--noprofile", "--norc", "--noediting", "-i"}), environment());
  bash.send("PS1='sh''ell: '; $MEANDER --no-rc\r");
  bash.wait_for("leaves.\r\n");
  bash.wait_for("> ");
  bash.send("kept = 5\r");
  bash.wait_for("\r\n> ");
  bash.send("half a li");
  bash.wait_for("half a li");
  bash.send("\x1a");
  bash.wait_for("Stopped");
  bash.wait_for("shell: ");
  EXPECT_TRUE(bash.is_cooked());
  bash.send("fg\r");
  bash.wait_for("> half a li");
  bash.send("\x15kept + 1\r");
  bash.wait_for("\n6\r\n");
  bash.wait_for("> ");
  bash.send("while true do for i = 1, 100000 do kept = i end print 'tick' end\r");
  bash.wait_for("tick\r\n");
  bash.send("\x1a");
  bash.wait_for("shell: ");
  bash.send("\rfg\r");
  bash.wait_for("--no-rc\r\n");
  bash.wait_for("tick\r\n");
  bash.send("\x03");
  bash.wait_for("interrupted\r\n> ");
}

TEST_P(Signals, FollowsTheSizeOfTheWindow) {
  t.resize(24, 40);
  t.send("return '" + std::string(60, 'x') + "'");
  t.wait_for("xxx");
  t.resize(24, 100);
  t.send(" .. 'end'\r");
  t.wait_for("\n\"" + std::string(60, 'x') + "end\"\r\n");
}

TEST_P(Signals, AClosedTerminalEndsTheProgram) {
  t.hang_up();
  EXPECT_EQ(t.wait_for_death(), 128 + SIGHUP);
  for (const char* busy : {"while true do end", "while true do pcall(function() while true do end end) end",
                           "study.trials { count = 1000000, trial = function() while true do end end }"}) {
    Terminal session(home.path(), program({"--no-rc"}), environment());
    session.wait_for("> ");
    session.send(std::string("print 'begun' ") + busy + "\r");
    session.wait_for("begun\r\n");
    session.hang_up();
    EXPECT_EQ(session.wait_for_death(), 128 + SIGHUP) << busy;
  }
}

TEST_P(Signals, PipesGetNoEscapeCodes) {
  Terminal session(home.path(),
                   shell("printf '1 + 1\\nprnt\\nshow(meander.world.new {})\\n.timer\\na\\0b\\n' | "
                         "$MEANDER -i --no-rc > out 2> err; echo code $?"),
                   environment());
  session.wait_for("code 0\r\n");
  EXPECT_TRUE(file_text("out").starts_with("2\n")) << file_text("out");
  EXPECT_TRUE(file_text("err").starts_with("undeclared variable 'prnt'")) << file_text("err");
  for (const char* name : {"out", "err"})
    for (const char c : file_text(name)) EXPECT_FALSE(c == '\x1b' || c == '\r' || c == '\0') << name;
}

TEST_P(Signals, NoColorMeansNone) {
  auto plain = environment();
  plain["NO_COLOR"] = "1";
  Terminal session(home.path(), program({"--no-rc"}), plain);
  session.wait_for("> ");
  session.enter("show(world.new { bounds = { { 0, 0 }, { 2, 2 } } })");
  session.enter("nonsense");
  for (const char* color : {"\x1b[3", "\x1b[4", "\x1b[38", "\x1b[1m"})
    EXPECT_EQ(session.raw_transcript().find(color), std::string::npos);
}

}  // namespace
}  // namespace meander::test
