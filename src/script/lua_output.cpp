// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>

#include "script/lua_setup.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

/// Takes the progress line away, then does what the function in the first upvalue does.
int after_hiding(lua_State* L) {
  hide_progress(L);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

/// The function called `name` in the table on top of the stack.
void wrap(lua_State* L, const char* name) {
  if (lua_getfield(L, -1, name) != LUA_TFUNCTION) return lua_pop(L, 1);
  lua_pushcclosure(L, after_hiding, 1);
  lua_setfield(L, -2, name);
}

}  // namespace

void open_output(lua_State* L) {
  lua_pushglobaltable(L);
  wrap(L, "print");
  if (lua_getfield(L, -1, "io") == LUA_TTABLE) wrap(L, "write");
  lua_pop(L, 2);
}

}  // namespace meander::script
