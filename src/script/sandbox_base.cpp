// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>

#include <cstdio>

#include "base/visible_text.hpp"
#include "script/file_access.hpp"
#include "script/sandbox_libraries.hpp"
#include "script/sandbox_state.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

/// load(chunk, name, mode, env): texts only, whatever the mode.
int safe_load(lua_State* L) {
  if (lua_gettop(L) < 3) lua_settop(L, 3);
  lua_pushliteral(L, "t");
  lua_replace(L, 3);
  return call_original(L);
}

/// Pushes the chunk of the file named by argument 1, or nil and why not.
int load_file(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  std::string problem;
  try {
    if (luaL_loadfilex(L, path_to_read(L, name).c_str(), "t") == LUA_OK) return 1;
  } catch (const std::exception& error) {
    problem = error.what();
    lua_pushlstring(L, problem.data(), problem.size());
  }
  lua_pushnil(L);
  lua_insert(L, -2);
  return 2;
}

int safe_loadfile(lua_State* L) {
  const bool environment = lua_gettop(L) >= 3;
  const int results = load_file(L);
  if (results == 1 && environment) {
    lua_pushvalue(L, 3);
    if (!lua_setupvalue(L, -2, 1)) lua_pop(L, 1);
  }
  return results;
}

int safe_dofile(lua_State* L) {
  lua_settop(L, 1);
  if (load_file(L) != 1) return lua_error(L);
  lua_call(L, 0, LUA_MULTRET);
  return lua_gettop(L) - 1;
}

/// No finalizers: they run where no hook counts, and could keep the program for ever.
int safe_setmetatable(lua_State* L) {
  if (lua_istable(L, 2)) {
    lua_pushliteral(L, "__gc");
    if (lua_rawget(L, 2) != LUA_TNIL) return luaL_error(L, "sandbox: no finalizers (__gc)");
    lua_pop(L, 1);
  }
  return call_original(L);
}

/// A handler of xpcall runs inside the hook that stops a script, where no hook counts: it is not asked then.
int guarded_handler(lua_State* L) {
  const Session& s = session(L);
  if (s.stop.requested() || !s.sandbox->verdict().empty()) return 1;
  return call_original(L);
}

int finish_xpcall(lua_State* L, int status, lua_KContext) {
  const bool done = status == LUA_OK || status == LUA_YIELD;
  lua_pushboolean(L, done);
  if (!done) {
    lua_insert(L, -2);
    return 2;
  }
  lua_replace(L, 1);  // the handler's place
  return lua_gettop(L);
}

int safe_xpcall(lua_State* L) {
  luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_pushvalue(L, 2);
  lua_pushcclosure(L, guarded_handler, 1);
  lua_pushvalue(L, 1);
  lua_replace(L, 2);
  lua_replace(L, 1);
  return finish_xpcall(L, lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 1, 0, finish_xpcall), 0);
}

int safe_collectgarbage(lua_State* L) {
  static const char* const options[] = {"collect", "count", "step", nullptr};
  switch (luaL_checkoption(L, 1, "collect", options)) {
    case 1:
      lua_pushnumber(L, lua_gc(L, LUA_GCCOUNT) + lua_gc(L, LUA_GCCOUNTB) / 1024.0);
      return 1;
    case 2:
      lua_pushboolean(L, lua_gc(L, LUA_GCSTEP, 0));
      return 1;
    default:
      lua_pushinteger(L, lua_gc(L, LUA_GCCOLLECT));
      return 1;
  }
}

/// A terminal is not commanded, nor one behind a pipe.
void write_charged(lua_State* L, const char* text, std::size_t size) {
  charge_output(L, size);
  const std::string visible = visible_text({text, size});
  std::fwrite(visible.data(), 1, visible.size(), stdout);
}

int safe_print(lua_State* L) {
  const int count = lua_gettop(L);
  for (int i = 1; i <= count; ++i) {
    std::size_t size = 0;
    const char* text = luaL_tolstring(L, i, &size);
    if (i > 1) write_charged(L, "\t", 1);
    write_charged(L, text, size);
    lua_pop(L, 1);
  }
  write_charged(L, "\n", 1);
  std::fflush(stdout);
  return 0;
}

/// debug.getinfo of a function, not of what runs: where it was written.
int safe_getinfo(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_Debug function;
  lua_settop(L, 1);
  lua_getinfo(L, ">S", &function);
  lua_createtable(L, 0, 4);
  lua_pushstring(L, function.what);
  lua_setfield(L, -2, "what");
  lua_pushlstring(L, function.source, function.srclen);
  lua_setfield(L, -2, "source");
  lua_pushstring(L, function.short_src);
  lua_setfield(L, -2, "short_src");
  lua_pushinteger(L, function.linedefined);
  lua_setfield(L, -2, "linedefined");
  return 1;
}

/// Puts a function before the one of this name in the table on top.
void wrap(lua_State* L, const char* name, lua_CFunction function) {
  lua_getfield(L, -1, name);
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, name);
}

}  // namespace

void charge_output(lua_State* L, std::size_t size) {
  std::string problem;
  try {
    return session(L).sandbox->charge_output(size);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  luaL_error(L, "%s", problem.c_str());
}

void add_safe_base(lua_State* L) {
  const luaL_Reg plain[] = {{"loadfile", safe_loadfile}, {"dofile", safe_dofile},
                            {"xpcall", safe_xpcall},     {"collectgarbage", safe_collectgarbage},
                            {"print", safe_print},       {nullptr, nullptr}};
  luaL_setfuncs(L, plain, 0);
  wrap(L, "load", safe_load);
  wrap(L, "setmetatable", safe_setmetatable);
}

void add_safe_debug(lua_State* L) {
  lua_pushcfunction(L, safe_getinfo);
  lua_setfield(L, -2, "getinfo");
}

}  // namespace meander::script
