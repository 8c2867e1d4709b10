// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Completion and pastes: what single keys do.
#include <algorithm>

#include "repl_at_prompt.hpp"

namespace meander::test {
namespace {

struct Keys : AtPrompt {
  /// Types the text and Tab, and what is more once `completed` stands there; gives up the line.
  void completes(const std::string& typed, const std::string& completed) {
    t.send(typed + "\t");
    EXPECT_NO_THROW(t.wait_for(completed)) << typed;
    t.send("\x03");
    t.wait_for("^C\r\n> ");
  }
};
INSTANTIATE_TEST_SUITE_P(, Keys, testing::ValuesIn(kTerminals), terminal_name);

TEST_P(Keys, TabCompletesNamesMethodsAndOptions) {
  t.enter("w = world.new {}");
  t.enter("fields = { inner = { deep_one = 1 } }");
  completes("pri", "print");
  completes("x = math.flo", "math.floor");
  completes("fields.inner.de", "deep_one");
  completes("w:add_pol", "add_polygon");
  completes("world.new {}:add_pol", "add_polygon");
  completes("w:add_box { cen", "center = ");
  completes("sim.new { sonar = { range_ma", "range_max = ");
  completes("?sim:dri", "sim:drive");
}

TEST_P(Keys, TabCompletesInsideQuotes) {
  write_file("a_script.lua", "loaded = true");
  write_file("dotted.name-1.lua", "");
  completes("dofile 'a_s", "a_script.lua'");
  completes("dofile('dotted.na", "dotted.name-1.lua'");
  completes("require 'meander.js", "meander.json'");
  completes("sim.new { robot = 'noma", "nomad200'");
  completes(".load a_s", "a_script.lua");
  completes(".load dotted.na", "dotted.name-1.lua");
  completes(".ti", ".timer");
}

TEST_P(Keys, TabCompletesFilesThatComeWithTheProgram) {
  completes("world.open 'worlds/offi", "office.toml'");
  completes(".load examples/first", "first_run.lua");
}

TEST_P(Keys, TabListsWhatIsPossible) {
  t.enter("fields = { alpha = 1, alps = 2 }");
  t.send("fields.al\t");
  t.wait_for("alpha");
  t.wait_for("alps");
}

TEST_P(Keys, TabRunsNoCodeOfTheUser) {
  t.enter("trap = setmetatable({}, { __index = function() print 'ran' end, __pairs = function() print 'ran' end })");
  t.send("trap.x.y\t\t");
  t.send("\x03");
  t.wait_for("^C\r\n> ");
  EXPECT_EQ(t.transcript().find("ran\r\n"), std::string::npos);
}

TEST_P(Keys, TabIndentsLinesThatContinue) {
  EXPECT_EQ(t.enter("function f()"), ">>");
  t.send("\t");
  EXPECT_EQ(t.enter("return 7"), ">>");
  EXPECT_EQ(t.enter("end"), "");
  EXPECT_EQ(t.enter("f()"), "7\r\n");
}

/// A paste comes between marks where the terminal was asked for them, and as if typed at once elsewhere.
std::string pasted(const std::string& text, const std::string& term) {
  if (term != "dumb") return "\x1b[200~" + text + "\x1b[201~\r";
  std::string typed = text + "\r";
  std::replace(typed.begin(), typed.end(), '\n', '\r');
  return typed;
}

TEST_P(Keys, PastesAFunctionWithTabs) {
  std::string text = "function pasted(n)\n\tlocal pri = n\n";
  for (int i = 0; i < 27; ++i) text += "\tif pri == " + std::to_string(i) + " then\tpri = pri + 1\tend\n";
  text += "\treturn pri\nend";
  t.send(pasted(text, GetParam()) + "pasted(0) .. ' done'\r");
  t.wait_for("\n\"27 done\"\r\n> ");
  EXPECT_EQ(t.transcript().find("Display all"), std::string::npos);
  std::string line;
  std::ifstream history(home / ".local/state/meander/history");
  std::getline(history, line);
  EXPECT_TRUE(line.starts_with("function pasted(n)\\n\tlocal pri = n\\n")) << line;
  EXPECT_TRUE(line.ends_with("\\nend")) << line;
  t.send("\x10\x10\r");
  t.wait_for("\r\n> ");
  EXPECT_EQ(t.enter("pasted(3)"), "27\r\n");
}

TEST_P(Keys, PastesSeveralStatements) {
  t.send(pasted("a = 1\nb = a + 1\nprint('pasted ' .. b)", GetParam()));
  t.wait_for("pasted 2\r\n");
  t.wait_for("> ");
  EXPECT_EQ(t.enter("a + b"), "3\r\n");
}

}  // namespace
}  // namespace meander::test
