// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <optional>
#include <string>
#include <vector>

#include "script/completion_tokens.hpp"
#include "script/docs.hpp"

namespace meander::script {

using Tokens = std::vector<Token>;

/// Where in the arguments of a call, or in its option table, the end of a text stands.
struct CallPlace {
  std::size_t function_end = 0;     ///< the token behind the function's name
  std::size_t argument = 0;         ///< counted from 0
  std::vector<std::string> keys{};  ///< of the option tables around, outermost first
  bool in_table = false;
};

/// Follows the brackets outwards: tables that are options of tables, or elements of lists that are, up to the call they
/// belong to.
std::optional<CallPlace> place_of(const Tokens& tokens);

/// The argument of a documented function; null elsewhere.
const ArgumentDoc* argument_at(lua_State* L, const Tokens& tokens, const CallPlace& place);
/// The option that the keys lead to, outermost first; null where there is none.
const OptionDoc* option_at(const ArgumentDoc& argument, const std::vector<std::string>& keys);

}  // namespace meander::script
