// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <string_view>

#include "base/visible_text.hpp"
#include "script/file_access.hpp"
#include "script/lua_interrupt.hpp"
#include "script/sandbox_libraries.hpp"
#include "script/sandbox_state.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

/// Replaces the file name at `index` by the path that it stands for. False with the reason on top when it may not be
/// used.
bool replace_name(lua_State* L, int index, bool reads) {
  const std::string name = luaL_checkstring(L, index);
  std::string text;
  bool allowed = true;
  try {
    text = reads ? path_to_read(L, name) : path_to_write(L, name);
  } catch (const std::exception& error) {
    text = error.what();
    allowed = false;
  }
  lua_pushlstring(L, text.data(), text.size());
  if (allowed) lua_replace(L, index);
  return allowed;
}

/// As Lua's own functions of files fail: nil and the reason, which is on top.
int refuse(lua_State* L) {
  lua_pushnil(L);
  lua_insert(L, -2);
  return 2;
}

int safe_open(lua_State* L) {
  const std::string_view mode = luaL_optstring(L, 2, "r");
  const bool reads = mode == "r" || mode == "rb";
  return replace_name(L, 1, reads) ? call_original(L) : refuse(L);
}

int safe_lines(lua_State* L) {
  luaL_checkstring(L, 1);
  return replace_name(L, 1, true) ? call_original(L) : lua_error(L);
}

int safe_remove(lua_State* L) {
  lua_settop(L, 1);
  return replace_name(L, 1, false) ? call_original(L) : refuse(L);
}

int safe_rename(lua_State* L) {
  lua_settop(L, 2);
  return replace_name(L, 1, false) && replace_name(L, 2, false) ? call_original(L) : refuse(L);
}

/// What may reach a terminal may not command it.
void make_visible(lua_State* L, int from) {
  for (int i = from; i <= lua_gettop(L); ++i) {
    if (lua_type(L, i) != LUA_TSTRING) continue;
    std::size_t size = 0;
    const char* text = lua_tolstring(L, i, &size);
    const std::string visible = visible_text({text, size});
    lua_pushlstring(L, visible.data(), visible.size());
    lua_replace(L, i);
  }
}

/// The file at `index` is open and one of the program's own: a terminal, or a pipe that may lead to one.
bool is_standard(lua_State* L, int index) {
  const auto* stream = static_cast<luaL_Stream*>(luaL_testudata(L, index, LUA_FILEHANDLE));
  return stream && stream->closef && fileno(stream->f) <= STDERR_FILENO;
}

/// file:write(...); and io.write(...), which has standard output as upvalue 2.
int safe_write(lua_State* L) {
  constexpr std::size_t kNumber = 24;  // bytes of the longest one
  for (int i = lua_gettop(L); i >= 1; --i)
    if (const int type = lua_type(L, i); type == LUA_TSTRING || type == LUA_TNUMBER)
      charge_output(L, type == LUA_TSTRING ? lua_rawlen(L, i) : kNumber);
  if (!lua_isnone(L, lua_upvalueindex(2))) {
    lua_pushvalue(L, lua_upvalueindex(2));
    lua_insert(L, 1);
  }
  if (is_standard(L, 1)) make_visible(L, 2);
  return call_original(L);
}

/// os.exit(code): the script ends, the program does what is left to do.
int safe_exit(lua_State* L) {
  Session& s = session(L);
  if (s.at_prompt) return luaL_error(L, "sandbox: no os.exit at the prompt; .quit leaves it");
  const lua_Integer code = lua_isboolean(L, 1) ? (lua_toboolean(L, 1) ? 0 : 1) : luaL_optinteger(L, 1, 0);
  s.sandbox->leave(static_cast<int>(code & 0xff));
  stop_running();
  lua_pushstring(L, s.sandbox->verdict().c_str());
  return lua_error(L);
}

/// Sets table[name] for the table on top: a closure over original[name] and, where there is one, a second value.
void wrap(lua_State* L, int original, const char* name, lua_CFunction function) {
  lua_getfield(L, original, name);
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, name);
}

/// Replaces the methods of open files by a table of harmless ones.
void lock_files(lua_State* L) {
  luaL_getmetatable(L, LUA_FILEHANDLE);
  const int metatable = lua_gettop(L);
  lua_getfield(L, metatable, "__index");
  const int original = lua_gettop(L);
  lua_newtable(L);
  for (const char* name : {"close", "flush", "lines", "read", "seek"}) {
    lua_getfield(L, original, name);
    lua_setfield(L, -2, name);
  }
  wrap(L, original, "write", safe_write);
  lua_setfield(L, metatable, "__index");
  lua_pushliteral(L, "locked");
  lua_setfield(L, metatable, "__metatable");
  lua_settop(L, metatable - 1);
}

}  // namespace

void add_safe_io(lua_State* L, int original) {
  lua_getglobal(L, "io");
  wrap(L, original, "open", safe_open);
  wrap(L, original, "lines", safe_lines);
  lua_getfield(L, original, "stdout");
  lua_getfield(L, -1, "write");
  lua_insert(L, -2);
  lua_pushcclosure(L, safe_write, 2);
  lua_setfield(L, -2, "write");
  lua_pop(L, 1);
  lock_files(L);
}

void add_safe_os(lua_State* L, int original) {
  lua_getglobal(L, "os");
  wrap(L, original, "remove", safe_remove);
  wrap(L, original, "rename", safe_rename);
  lua_pushcfunction(L, safe_exit);
  lua_setfield(L, -2, "exit");
  lua_pop(L, 1);
}

}  // namespace meander::script
