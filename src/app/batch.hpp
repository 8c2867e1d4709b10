// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "app/command_line.hpp"
#include "script/interpreter.hpp"

namespace meander {

/// The interpreter as the command line wants it, with colours and a progress line where there is a terminal.
void set_up_terminal(script::Interpreter& lua);
/// Says on stderr what went wrong, if anything, and gives the exit code.
int report(const script::Outcome& outcome);
/// Everything but the prompt, in the order modules, code, script; stops at the first that fails. Gives the exit code.
int run_batch(script::Interpreter& lua, const CommandLine& line);
/// A subcommand that is written in Lua: the embedded module meander.commands.NAME, with the arguments in `arg`.
int run_lua_command(const std::string& name, const CommandLine& line);

}  // namespace meander
