// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/kit_value.hpp"

namespace meander::script {

/// Any Lua value, left on the stack.
struct Any {
  lua_State* L;
  int index;
};
template <>
struct Lua<Any> {
  static Any read(lua_State* L, int index, const Path&) { return {L, index}; }
  static std::string type() { return "any"; }
};

}  // namespace meander::script
