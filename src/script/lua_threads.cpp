// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>
#include <lua.h>

#include "script/lua_interrupt.hpp"
#include "script/lua_setup.hpp"
#include "script/sandbox_state.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

lua_State* thread_argument(lua_State* L) {
  lua_State* thread = lua_tothread(L, 1);
  luaL_argexpected(L, thread, 1, "coroutine");
  return thread;
}

/// Started or suspended, and not one that is further up in the chain of resumes.
bool at_rest(lua_State* L, lua_State* thread) {
  lua_Debug activation;
  return thread != L && !(lua_status(thread) == LUA_OK && lua_getstack(thread, 0, &activation));
}

bool dead(lua_State* thread) {
  const int status = lua_status(thread);
  return status != LUA_YIELD && (status != LUA_OK || lua_gettop(thread) == 0);
}

/// Moves `count` values from L to `thread`, runs it, and moves what it yields, returns or raises back to L.
/// The number of values, or -1 with the error on top of L.
int run_thread(lua_State* L, lua_State* thread, int count) {
  if (!at_rest(L, thread) || dead(thread)) {
    lua_pushfstring(L, "cannot resume %s coroutine", at_rest(L, thread) ? "dead" : "non-suspended");
    return -1;
  }
  if (!lua_checkstack(thread, count)) return lua_pushliteral(L, "too many arguments to resume"), -1;
  if (lua_status(thread) == LUA_OK) charge_coroutine(L);
  lua_xmove(L, thread, count);
  int results = 0;
  const RunningThread running(thread, L);
  const int status = lua_resume(thread, L, count, &results);
  if (status != LUA_OK && status != LUA_YIELD) return lua_xmove(thread, L, 1), -1;
  if (!lua_checkstack(L, results + 1)) {
    lua_pop(thread, results);
    return lua_pushliteral(L, "too many results to resume"), -1;
  }
  lua_xmove(thread, L, results);
  return results;
}

int resume(lua_State* L) {
  lua_State* thread = thread_argument(L);
  const int results = run_thread(L, thread, lua_gettop(L) - 1);
  lua_pushboolean(L, results >= 0);
  const int returned = results >= 0 ? results : 1;
  lua_insert(L, -(returned + 1));
  return returned + 1;
}

/// Closes the pending to-be-closed variables of `thread`; an error in them is left on its stack.
int close_thread(lua_State* L, lua_State* thread) {
  const RunningThread running(thread, L);
  return lua_resetthread(thread);
}

int resume_wrapped(lua_State* L) {
  lua_State* thread = lua_tothread(L, lua_upvalueindex(1));
  const int results = run_thread(L, thread, lua_gettop(L));
  if (results >= 0) return results;
  const int status = lua_status(thread);
  if (status != LUA_OK && status != LUA_YIELD) {
    close_thread(L, thread);
    lua_xmove(thread, L, 1);
  }
  const bool interrupted = session(L).stop.requested();
  if (!interrupted && status != LUA_ERRMEM && lua_type(L, -1) == LUA_TSTRING) {
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
  }
  return lua_error(L);
}

int wrap(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_State* thread = lua_newthread(L);
  lua_pushvalue(L, 1);
  lua_xmove(L, thread, 1);
  lua_pushcclosure(L, resume_wrapped, 1);
  return 1;
}

int close(lua_State* L) {
  lua_State* thread = thread_argument(L);
  if (!at_rest(L, thread)) return luaL_error(L, "cannot close a %s coroutine", thread == L ? "running" : "normal");
  const bool clean = close_thread(L, thread) == LUA_OK;
  lua_pushboolean(L, clean);
  if (clean) return 1;
  lua_xmove(thread, L, 1);
  return 2;
}

}  // namespace

void open_threads(lua_State* L) {
  const luaL_Reg functions[] = {{"resume", resume}, {"wrap", wrap}, {"close", close}, {nullptr, nullptr}};
  lua_getglobal(L, "coroutine");
  luaL_setfuncs(L, functions, 0);
  lua_pop(L, 1);
}

}  // namespace meander::script
