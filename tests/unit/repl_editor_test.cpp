// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// .edit with editors that are scripts.
#include <filesystem>

#include "repl_at_prompt.hpp"

namespace meander::test {
namespace {

struct Editing : AtPrompt {
  void use_editor(const std::string& script) const { write_file("editor", "#!/bin/sh\n" + script + "\n", true); }
  /// What .edit writes up to the next prompt; it may look like a prompt itself.
  static std::string edit(Terminal& t, const std::string& expected) {
    t.send(".edit\r");
    t.wait_for(".edit\r\n");
    return t.wait_for(expected + "> ");
  }
  /// Files that an editor was given lie in $TMPDIR, which is the home.
  int left_over() const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(home.path()))
      count += entry.path().filename().string().starts_with("meander-");
    return count;
  }
};
INSTANTIATE_TEST_SUITE_P(, Editing, testing::ValuesIn(kTerminals), terminal_name);

TEST_P(Editing, RunsTheLastInputAnew) {
  use_editor("stat -c %a \"$1\" > mode; sed -i s/5/6/ \"$1\"");
  t.enter("a = 5");
  edit(t, "> a = 6\r\n");
  EXPECT_EQ(t.enter("a"), "6\r\n");
  EXPECT_EQ(file_text("mode"), "600\n");
  EXPECT_EQ(left_over(), 0);
  EXPECT_EQ(file_text(".local/state/meander/history"), "a = 5\n.edit\na = 6\na\n");
  t.enter(".save log.lua");
  EXPECT_EQ(file_text("log.lua"), "a = 5\na = 6\nprint(a)\n");
}

TEST_P(Editing, TakesSeveralLinesAndWhatFailed) {
  use_editor("printf 'for i = 1, 2 do\n\tprint(i)\nend\n\n' > \"$1\"");
  t.enter("for = 1");
  edit(t, "> for i = 1, 2 do\r\n>> \tprint(i)\r\n>> end\r\n1\r\n2\r\n");
  use_editor("echo 'f(' > \"$1\"");
  edit(t, "> f(\r\nunexpected symbol near <eof>\r\n");
}

TEST_P(Editing, BeginsWithTheInputOfTheSessionBefore) {
  t.enter("old = 5");
  t.enter("?deg");
  Terminal next(home.path(), program({"--no-rc"}), environment());
  next.wait_for("> ");
  use_editor("sed -i s/old/new/ \"$1\"");
  edit(next, "> new = 5\r\n");
}

TEST_P(Editing, RunsNothingWithoutAChange) {
  t.enter("print 'once'");
  use_editor("true");
  EXPECT_EQ(t.enter(".edit"), "(unchanged: not run)\r\n");
  use_editor("echo > \"$1\"");
  EXPECT_EQ(t.enter(".edit"), "(empty: nothing to run)\r\n");
  use_editor("echo 'print(2)' > \"$1\"; exit 3");
  EXPECT_EQ(t.enter(".edit"), "the editor '" + home / "editor" + "' failed with exit code 3\r\n");
  use_editor("kill -9 $$");
  EXPECT_NE(t.enter(".edit").find("ended by signal 9\r\n"), std::string::npos);
  use_editor("rm \"$1\"");
  EXPECT_NE(t.enter(".edit").find("no such file"), std::string::npos);
  EXPECT_EQ(t.enter("1"), "1\r\n");
  EXPECT_EQ(left_over(), 0);
}

TEST_P(Editing, TellsWhatIsMissing) {
  EXPECT_NE(t.enter(".edit").find("no editor '" + home / "editor" + "'"), std::string::npos);
  auto none = environment();
  none["EDITOR"] = "";
  none["PATH"] = home.path();
  Terminal bare(home.path(), program({"--no-rc"}), none);
  bare.wait_for("> ");
  EXPECT_EQ(bare.enter(".edit"),
            "no editor: set VISUAL or EDITOR to the one you like, in the shell: export EDITOR=nano\r\n");
}

TEST_P(Editing, PutsTheTerminalBack) {
  use_editor("stty raw -echo; echo 'x = 1' > \"$1\"");
  edit(t, "> x = 1\r\n");
  EXPECT_EQ(
      t.enter("io.popen('stty -a'):read('a'):match('-?echo%f[ ]'), io.popen('stty -a'):read('a'):match('-?icanon')"),
      "\"echo\"  \"icanon\"\r\n");
}

TEST_P(Editing, LeavesCtrlCToTheEditor) {
  use_editor("trap 'echo \"print(7)\" > \"$1\"; exit 0' INT; echo opened; while :; do sleep 0.01; done");
  t.send(".edit\r");
  t.wait_for("opened\r\n");
  t.send("\x03");
  t.wait_for("> print(7)\r\n7\r\n> ");
  EXPECT_EQ(t.enter("1"), "1\r\n");
}

TEST_P(Editing, EditsAndLoadsAScript) {
  use_editor("echo 'loaded = (loaded or 0) + 1' > \"$1\"");
  EXPECT_EQ(t.enter("loaded = nil"), "");
  EXPECT_EQ(t.enter(".edit my.lua"), "");
  EXPECT_EQ(t.enter("loaded"), "1\r\n");
  EXPECT_EQ(t.enter(".edit my.lua"), "(unchanged: not run; .load runs it)\r\n");
  use_editor("true");
  EXPECT_EQ(t.enter(".edit other.lua"), "('other.lua' was not written)\r\n");
}

}  // namespace
}  // namespace meander::test
