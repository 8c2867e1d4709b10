// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>
#include <string>

#include "repl_pty.hpp"

namespace meander::test {

/// The kinds of terminal on which everything must work: TERM.
inline constexpr const char* kTerminals[] = {"dumb", "xterm-256color"};

inline std::string terminal_name(const testing::TestParamInfo<const char*>& info) {
  return std::string(info.param) == "dumb" ? "Dumb" : "Xterm";
}

/// The program at its first prompt, in an empty home, on each kind of terminal.
class AtPrompt : public testing::TestWithParam<const char*> {
 protected:
  AtPrompt() { t.wait_for("> "); }

  std::string file_text(const std::string& name) const {
    std::ifstream file(home / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write_file(const std::string& name, const std::string& text, bool program = false) const {
    std::ofstream(home / name) << text;
    if (program) chmod((home / name).c_str(), 0700);
  }
  std::map<std::string, std::string> environment() const {
    return {{"TERM", GetParam()}, {"EDITOR", home / "editor"}, {"TMPDIR", home.path()}};
  }

  const TemporaryFolder home;
  Terminal t{home.path(), program({"--no-rc"}), environment()};
};

}  // namespace meander::test
