// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "script/completion.hpp"

namespace meander::repl {

/// A line that starts with a dot and a letter, or with a question mark, is for the prompt itself, not for Lua.
bool is_command(std::string_view line);

/// ".load  a b.lua " is {".load", "a b.lua"}, "?world" and "? world" are {"?", "world"}.
struct Command {
  std::string name;
  std::string argument;
};
Command split_command(std::string_view line);

/// The names of all commands, with their dots, and "?".
std::vector<std::string> command_names();
/// The beginning of a line that will be a command with a dot.
bool starts_command(std::string_view line);
/// What may stand at the end of such a line.
script::Completion complete_command(std::string_view line);

/// What to say to a lone word of other programs, as "exit" or "ls()", that failed as Lua, and to "help"; or empty.
std::string word_hint(std::string_view input, bool failed);
/// What .help writes.
std::string command_help();

}  // namespace meander::repl
