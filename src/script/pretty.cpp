// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/pretty.hpp"

namespace meander::script {
namespace {

constexpr const char* kPretty = "meander.pretty";

}  // namespace

void open_pretty(lua_State* L) {
  lua_getglobal(L, "require");
  lua_pushstring(L, kPretty);
  lua_call(L, 1, 1);
  lua_setfield(L, LUA_REGISTRYINDEX, kPretty);
}

bool push_pretty(lua_State* L, const char* name) {
  if (lua_getfield(L, LUA_REGISTRYINDEX, kPretty) != LUA_TTABLE) return lua_pop(L, 1), false;
  lua_pushstring(L, name);
  if (lua_rawget(L, -2) != LUA_TFUNCTION) return lua_pop(L, 2), false;
  lua_remove(L, -2);
  return true;
}

}  // namespace meander::script
