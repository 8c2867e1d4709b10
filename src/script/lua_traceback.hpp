// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <string>
#include <vector>

namespace meander::script {

/// What an uncaught error left behind.
struct ErrorReport {
  std::string message;             ///< with the script position in front where there is one
  std::vector<std::string> trace;  ///< "demo.lua:3: in function 'f'", innermost first; empty when it would say nothing
};

/// lua_pcall with `count` arguments on the stack and a message handler that fills `report`. True on success, with all
/// results on the stack; otherwise nothing is left there.
bool call_reporting(lua_State* L, int count, ErrorReport& report);

/// Takes the text on top off the stack.
std::string pop_text(lua_State* L);

/// Message and trace, one line each, the trace indented. Ends without a line break.
std::string text_of(const ErrorReport& report);

}  // namespace meander::script
