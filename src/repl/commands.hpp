// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>
#include <vector>

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
/// What .help writes.
std::string command_help();

}  // namespace meander::repl
