// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "script/interpreter.hpp"

namespace meander::repl {

struct PromptOptions {
  std::string version;   ///< for the greeting
  bool start_up = true;  ///< run the start-up file
  bool history = true;   ///< remember what is typed beyond the session
};

/// Reads and runs what the user types until the end of input. Returns the exit code.
int run_prompt(script::Interpreter& lua, const PromptOptions& options);

}  // namespace meander::repl
