// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/command_line.hpp"

namespace meander {

/// What `meander NAME ARGUMENTS...` does instead of running a script called NAME.
struct Subcommand {
  const char* name;
  const char* arguments;                ///< for --help: "IN OUT"
  const char* text;                     ///< one line without the final stop
  int (*run)(const CommandLine& line);  ///< `line.arguments` is what follows NAME; gives the exit code
};

std::span<const Subcommand> subcommands();
std::vector<std::string> subcommand_names();
/// nullptr: `name` is a script.
const Subcommand* find_subcommand(std::string_view name);

// One file each, <name>_command.cpp; those in Lua are lua/commands/<name>.lua.
int doc_command(const CommandLine& line);
int test_command(const CommandLine& line);

}  // namespace meander
