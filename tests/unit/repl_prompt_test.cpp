// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "repl_pty.hpp"

namespace meander::test {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The program at its first prompt.
struct Session {
  explicit Session(const std::map<std::string, std::string>& environment = {})
      : terminal(home.path(), program({"--no-rc"}), environment) {
    terminal.wait_for("> ");
  }
  TemporaryFolder home;
  Terminal terminal;
};

TEST(Prompt, GreetsAndLeaves) {
  Session session;
  EXPECT_EQ(session.terminal.transcript().find("meander "), 0u);
  session.terminal.send("\x04");
  EXPECT_EQ(session.terminal.wait_for_exit(), 0);
  EXPECT_TRUE(session.terminal.transcript().ends_with("> \r\n"));
}

TEST(Prompt, EchoesValues) {
  Session session;
  Terminal& t = session.terminal;
  EXPECT_EQ(t.enter("1 + 1"), "2\r\n");
  EXPECT_EQ(t.enter("_ * 21"), "42\r\n");
  EXPECT_EQ(t.enter("= _ + 1"), "43\r\n");
  EXPECT_EQ(t.enter("x = 5"), "");
  EXPECT_EQ(t.enter("x, nil, 'text'"), "5  nil  \"text\"\r\n");
  EXPECT_EQ(t.enter("print 'said'"), "said\r\n");
  EXPECT_EQ(t.enter("(function() end)()"), "");
  EXPECT_EQ(t.enter("{ 1, { a = true }, name = 'n' }"), "{ 1, { a = true }, name = \"n\" }\r\n");
  EXPECT_EQ(t.enter("  "), "");
  EXPECT_EQ(t.enter("-- a comment"), "");
}

TEST(Prompt, ContinuesUntilComplete) {
  Session session;
  Terminal& t = session.terminal;
  EXPECT_EQ(t.enter("for i = 1, 2 do"), ">>");
  EXPECT_EQ(t.enter("  print(i)"), ">>");
  EXPECT_EQ(t.enter("end"), "1\r\n2\r\n");
  EXPECT_EQ(t.enter("1 +"), ">>");
  EXPECT_EQ(t.enter("2"), "3\r\n");
  EXPECT_EQ(t.enter("t = {"), ">>");
  EXPECT_EQ(t.enter("}"), "");
  EXPECT_EQ(t.enter("s = [[one"), ">>");
  EXPECT_EQ(t.enter("two]]"), "");
  EXPECT_EQ(t.enter("s"), "one\r\ntwo\r\n");
  EXPECT_EQ(t.enter("for = 1"), "<name> expected near '='\r\n");
}

TEST(Prompt, ExplainsMistakes) {
  Session session;
  Terminal& t = session.terminal;
  EXPECT_EQ(t.enter("prnt(1)"), "undeclared variable 'prnt'; did you mean 'print'?\r\n");
  EXPECT_EQ(t.enter("wrld"), "undeclared variable 'wrld'; did you mean 'world'?\r\n");
  EXPECT_EQ(t.enter("local y = 1"), "(a local ends with its line; without 'local' the value stays)\r\n");
  EXPECT_EQ(t.enter("function f(a) return a.b.c end function g(a) return (f(a)) end"), "");
  EXPECT_EQ(t.enter("g {}"), "attempt to index a nil value (field 'b')\r\n  in function 'f'\r\n  in function 'g'\r\n");
  EXPECT_EQ(t.enter(".hlep"), "unknown command '.hlep'; did you mean '.help'? (.help lists them)\r\n");
  EXPECT_EQ(t.enter("function count() total = 1 end count() return total"), "1\r\n");
}

TEST(Prompt, ExplainsNames) {
  Session session;
  Terminal& t = session.terminal;
  const std::string text = t.enter("?deg");
  EXPECT_TRUE(text.starts_with("deg(angle)\r\n")) << text;
  EXPECT_EQ(t.enter(" ? deg "), text);
  EXPECT_EQ(t.enter("help 'deg'"), text);
  EXPECT_TRUE(t.enter("?").starts_with("functions\r\n"));
  EXPECT_EQ(t.enter("?sim:drvie"), "help: nothing is known about 'sim:drvie'; did you mean 'sim:drive'?\r\n");
  EXPECT_NE(t.enter(".help").find("?      NAME"), std::string::npos);
}

TEST(Prompt, EndOfInputInAContinuationLeavesNoTrace) {
  const std::map<std::string, std::string> xterm = {{"TERM", "xterm"}};
  Session session(xterm);
  Terminal& t = session.terminal;
  t.send("f(\r");
  t.wait_for(">> ");
  t.send("\x04");
  t.wait_for("> ");
  t.send("print 'one'\r");
  t.wait_for("\rone\r\n");
  const std::string transcript = t.transcript();
  const std::size_t typed = transcript.rfind("print 'one'");
  const std::string between = transcript.substr(typed);
  EXPECT_EQ(std::count(between.begin(), between.end(), '\n'), 2) << between;
}

TEST(Prompt, InterruptGivesUpTheLine) {
  Session session;
  Terminal& t = session.terminal;
  t.send("return 99");
  t.wait_for("return 99");
  t.send("\x03");
  t.wait_for("^C\r\n> ");
  EXPECT_EQ(t.enter("1"), "1\r\n");
  EXPECT_EQ(t.enter("function f()"), ">>");
  t.send("\x03");
  t.wait_for("^C\r\n> ");
  EXPECT_EQ(t.enter("2"), "2\r\n");
}

TEST(Prompt, CompletesNamesMethodsOptionsAndFiles) {
  Session session;
  std::ofstream(session.home / "a_script.lua") << "loaded = true";
  Terminal& t = session.terminal;
  t.send("pri\t");
  t.wait_for("print");
  EXPECT_EQ(t.enter("(7)"), "7\r\n");
  t.send("math.flo\t");
  t.wait_for("math.floor");
  EXPECT_EQ(t.enter("(2.5)"), "2\r\n");
  t.send("dofile 'a_s\t");
  t.wait_for("a_script.lua'");
  t.enter("");
  EXPECT_EQ(t.enter("loaded"), "true\r\n");
  t.send("meander.world.new {}:add_pol\t");
  t.wait_for("add_polygon");
  t.send("\x03");
  t.wait_for("> ");
}

TEST(Prompt, KeepsItsHistory) {
  TemporaryFolder home;
  {
    Terminal t(home.path(), program({"--no-rc"}));
    t.wait_for("> ");
    t.enter("kept = 'once'");
    t.enter("function two()");
    t.enter("return 2 end");
    t.enter("kept = 'once'");
    t.send("\x04");
    EXPECT_EQ(t.wait_for_exit(), 0);
  }
  const std::string path = home / ".local/state/meander/history";
  EXPECT_EQ(file_text(path), "kept = 'once'\nfunction two()\\nreturn 2 end\nkept = 'once'\n");
  struct stat status {};
  ASSERT_EQ(stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);

  Terminal t(home.path(), program({"--no-rc"}));
  t.wait_for("> ");
  t.send("\x10");  // Ctrl-P, as the arrow up
  t.wait_for("kept = 'once'");
  t.enter("");
  EXPECT_EQ(t.enter("kept"), "\"once\"\r\n");
}

TEST(Prompt, TakesASeveralLinePasteAsOne) {
  const std::map<std::string, std::string> xterm = {{"TERM", "xterm"}};
  Session session(xterm);
  session.terminal.send("\x1b[200~a = 1\nb = a + 1\nprint('pasted ' .. b)\x1b[201~\r");
  session.terminal.wait_for("pasted 2\r\n");
}

TEST(Prompt, WritesNoEscapeCodesToADumbTerminal) {
  Session session;
  session.terminal.enter("{ 1, 2 }");
  session.terminal.enter("nonsense");
  session.terminal.send("\x04");
  session.terminal.wait_for_exit();
  EXPECT_EQ(session.terminal.transcript().find('\x1b'), std::string::npos);
}

TEST(Prompt, LoadsAndSavesScripts) {
  Session session;
  std::ofstream(session.home / "part.lua") << "part = 7 print('part runs')";
  Terminal& t = session.terminal;
  EXPECT_EQ(t.enter(".load part.lua"), "part runs\r\n");
  EXPECT_EQ(t.enter("part * 2"), "14\r\n");
  EXPECT_EQ(t.enter("twice = _"), "");
  EXPECT_EQ(t.enter("nosuch.thing"), "undeclared variable 'nosuch'\r\n");
  EXPECT_EQ(t.enter("world.new {}:names()"), "{}\r\n");
  EXPECT_EQ(t.enter(".save part.lua"), "'part.lua' exists already; choose another name\r\n");
  EXPECT_EQ(t.enter(".save all.lua"), "saved as 'all.lua'\r\n");
  EXPECT_EQ(file_text(session.home / "all.lua"),
            "world = meander.world\ndofile(\"part.lua\")\n_ = part * 2\ntwice = _\nworld.new {}:names()\n");
  Terminal again(session.home.path(), program({"-i", "--no-rc", "all.lua"}));
  again.wait_for("> ");
  EXPECT_EQ(again.enter("twice"), "14\r\n");
}

TEST(Prompt, RunsTheStartUpFile) {
  TemporaryFolder home;
  std::ofstream(home / "init.lua") << "print 'not this one'";
  ASSERT_EQ(mkdir((home / "meander").c_str(), 0700), 0);
  std::ofstream(home / "meander/init.lua") << "greeting = 'from init.lua'";
  Terminal t(home.path(), program(), {{"XDG_CONFIG_HOME", home.path()}});
  t.wait_for("> ");
  EXPECT_EQ(t.enter("greeting"), "\"from init.lua\"\r\n");
}

TEST(Prompt, TellsTheTime) {
  Session session;
  EXPECT_EQ(session.terminal.enter(".timer"), "(timer on)\r\n");
  EXPECT_NE(session.terminal.enter("x = 1").find(" s)\r\n"), std::string::npos);
  EXPECT_EQ(session.terminal.enter(".timer off"), "(timer off)\r\n");
}

TEST(Prompt, FollowsAScriptWithI) {
  TemporaryFolder home;
  std::ofstream(home / "script.lua") << "value = #arg";
  Terminal t(home.path(), program({"-i", "--no-rc", "script.lua", "a", "b"}));
  t.wait_for("> ");
  EXPECT_EQ(t.enter("value"), "2\r\n");
}

}  // namespace
}  // namespace meander::test
