// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>

#include "repl_at_prompt.hpp"

namespace meander::test {
namespace {

using Prompt = AtPrompt;
INSTANTIATE_TEST_SUITE_P(, Prompt, testing::ValuesIn(kTerminals), terminal_name);

TEST_P(Prompt, GreetsAndLeaves) {
  EXPECT_EQ(t.transcript().find("meander "), 0u);
  t.send("\x04");
  EXPECT_EQ(t.wait_for_exit(), 0);
  EXPECT_TRUE(t.transcript().ends_with("> \r\n"));
  EXPECT_EQ(t.raw_transcript().find('\x1b') != std::string::npos, std::string(GetParam()) != "dumb");
}

TEST_P(Prompt, EchoesValues) {
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

TEST_P(Prompt, EchoesListsOfNumbersInRows) {
  EXPECT_EQ(t.enter("t = { x = 'a text' } for i = 1, 25 do t[i] = i end return t"),
            "{\r\n  1, 2, 3, 4, 5, 6, 7, 8, 9, 10,\r\n  11, 12, 13, 14, 15, 16, 17, 18, 19, 20,\r\n"
            "  21, 22, 23, 24, 25,\r\n  x = \"a text\"\r\n}\r\n");
}

TEST_P(Prompt, EchoesWhateverAScriptTakesAway) {
  EXPECT_EQ(t.enter("tostring, type, require, next, table = nil"), "");
  EXPECT_EQ(t.enter("{ a = 1, 2 }"), "{ 2, a = 1 }\r\n");
  EXPECT_EQ(t.enter("error { a = 1 }"), "error value is a table: { a = 1 }\r\n");
}

TEST_P(Prompt, ContinuesUntilComplete) {
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

TEST_P(Prompt, ExplainsMistakes) {
  EXPECT_EQ(t.enter("prnt(1)"), "undeclared variable 'prnt'; did you mean 'print'?\r\n");
  EXPECT_EQ(t.enter("wrld"), "undeclared variable 'wrld'; did you mean 'world'?\r\n");
  EXPECT_EQ(t.enter("local y = 1"), "(a local ends with its line; without 'local' the value stays)\r\n");
  EXPECT_EQ(t.enter("function f(a) return a.b.c end function g(a) return (f(a)) end"), "");
  EXPECT_EQ(t.enter("g {}"), "attempt to index a nil value (field 'b')\r\n  in function 'f'\r\n  in function 'g'\r\n");
  EXPECT_EQ(t.enter(".hlep"), "unknown command '.hlep'; did you mean '.help'? (.help lists them)\r\n");
  EXPECT_EQ(t.enter("function count() total = 1 end count() return total"), "1\r\n");
}

TEST_P(Prompt, ExplainsNames) {
  const std::string text = t.enter("?deg");
  EXPECT_TRUE(text.starts_with("deg(angle)\r\n")) << text;
  EXPECT_EQ(t.enter(" ? deg "), text);
  EXPECT_EQ(t.enter("help 'deg'"), text);
  EXPECT_TRUE(t.enter("?").starts_with("functions\r\n"));
  EXPECT_EQ(t.enter("?sim:drvie"), "help: nothing is known about 'sim:drvie'; did you mean 'sim:drive'?\r\n");
  EXPECT_NE(t.enter(".help").find("?      NAME"), std::string::npos);
}

TEST_P(Prompt, HintsAtWordsOfOtherPrograms) {
  EXPECT_EQ(t.enter("exit"), "undeclared variable 'exit'\r\n(.quit or Ctrl-D leaves)\r\n");
  EXPECT_EQ(t.enter(" quit() "), "undeclared variable 'quit'\r\n(.quit or Ctrl-D leaves)\r\n");
  EXPECT_NE(t.enter("ls").find("(this is Lua, not a shell; Tab inside quotes completes names of files)\r\n"),
            std::string::npos);
  EXPECT_EQ(t.enter("exit = 5"), "");
  EXPECT_EQ(t.enter("exit"), "5\r\n");
  EXPECT_NE(t.enter("help").find("(help() tells what there is, "), std::string::npos);
}

TEST_P(Prompt, TellsWhatALoneFunctionOrModuleIs) {
  EXPECT_TRUE(t.enter("deg").starts_with("deg(angle)  Radians from degrees"));
  EXPECT_TRUE(t.enter("sim").starts_with("meander.sim  Simulation"));
  EXPECT_EQ(t.enter("print"), "function\r\n");
}

TEST_P(Prompt, KnowsTheModuleBehindAnObjectOfItsName) {
  EXPECT_EQ(t.enter("world = meander.world.new {}"), "");
  EXPECT_EQ(t.enter("world.new {}"), "world: has no member 'new'; the module has it: meander.world.new\r\n");
  const std::string answer = t.enter("world.open 'x.toml'");
  EXPECT_NE(answer.find("(call it with ':', or meander.world.open of the module)\r\n"), std::string::npos) << answer;
}

TEST_P(Prompt, PrintsNestedTablesWithLimits) {
  EXPECT_EQ(t.enter("{{{{{1}}}}}"), "{ { { { { ... } } } } }\r\n");
  EXPECT_EQ(t.enter("c = { name = 'c' } c.self = c"), "");
  EXPECT_EQ(t.enter("c"), "{ name = \"c\", self = { (this table again) } }\r\n");
  EXPECT_EQ(t.enter("big = {} for i = 1, 100 do big[i] = i end"), "");
  EXPECT_NE(t.enter("big").find("\r\n  ... 60 more\r\n}\r\n"), std::string::npos);
  const std::string wide = t.enter("{ ('a'):rep(50), ('b'):rep(50) }");
  EXPECT_TRUE(wide.starts_with("{\r\n  \"aaa")) << wide;
  EXPECT_NE(t.enter("('x'):rep(5000)").find("\"... (5000 bytes)\r\n"), std::string::npos);
}

TEST_P(Prompt, LetsNoTextCommandTheTerminal) {
  EXPECT_EQ(t.enter(R"('\27[2J\0\7')"), "\"\\027[2J\\000\\007\"\r\n");
  EXPECT_EQ(t.enter(R"('one\ntwo\27[2J')"), "one\r\ntwo\\027[2J\r\n");
  EXPECT_EQ(t.enter(R"(error('\27]0;title\7', 0))"), "\\27]0;title\\7\r\n");
  EXPECT_EQ(t.enter(R"(setmetatable({}, { __tostring = function() return '\27[31mred' end }))"), "\\027[31mred\r\n");
  EXPECT_EQ(t.enter(R"(error('\xc2\x9b31m \xff', 0))"), "\\194\\15531m \\255\r\n");
  EXPECT_EQ(t.enter(R"(error('ein schöner Tag', 0))"), "ein schöner Tag\r\n");
}

TEST_P(Prompt, ReadsAndWritesUtf8) {
  EXPECT_EQ(t.enter("'äöü €'"), "\"äöü €\"\r\n");
  EXPECT_EQ(t.enter("utf8.len('日本語')"), "3\r\n");
  EXPECT_EQ(t.enter("print '日本語'"), "日本語\r\n");
  t.send("#'äx\x7f\x7fß'\r");  // the second Backspace takes a whole character
  t.wait_for("\n2\r\n> ");
}

TEST_P(Prompt, TakesVeryLongLines) {
  const std::string text(100000, 'x');
  t.send("#'" + text + "'\r");
  t.wait_for("\n100000\r\n");
  t.wait_for("> ");
  EXPECT_EQ(t.enter("1"), "1\r\n");
}

TEST_P(Prompt, SurvivesControlCharacters) {
  std::string all;
  for (char c = 0; c < 32; ++c)
    if (std::string("\x03\x04\x1a\n\r\x0f\x12\x13\x16\x1b\x18\x11").find(c) == std::string::npos) all += c;
  t.send(all + "\x03");
  t.wait_for("^C\r\n> ");
  EXPECT_EQ(t.enter("#'a\x16\x01"
                    "b'"),
            "3\r\n");  // Ctrl-V takes the next key as it is
}

TEST_P(Prompt, InterruptGivesUpTheLine) {
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

TEST_P(Prompt, TellsTheTime) {
  EXPECT_EQ(t.enter(".timer"), "(timer on)\r\n");
  EXPECT_NE(t.enter("x = 1").find(" s)\r\n"), std::string::npos);
  EXPECT_EQ(t.enter(".timer off"), "(timer off)\r\n");
}

}  // namespace
}  // namespace meander::test
