// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/sandbox_libraries.hpp"

#include <lauxlib.h>

#include <algorithm>
#include <span>
#include <string_view>

namespace meander::script {
namespace {

struct Library {
  const char* name;
  std::span<const std::string_view> kept;
};

// Not kept, because they would be the way out: in string dump; in os execute, getenv, setlocale, tmpname; in io popen,
// tmpfile, read and everything of standard input; in debug all that looks at or changes what belongs to others;
// package.
constexpr std::string_view kBase[] = {"_G",       "_VERSION",     "assert",   "error",    "getmetatable",
                                      "ipairs",   "load",         "next",     "pairs",    "pcall",
                                      "rawequal", "rawget",       "rawlen",   "rawset",   "require",
                                      "select",   "setmetatable", "tonumber", "tostring", "type"};
constexpr std::string_view kString[] = {"byte",  "char", "find",     "format", "gmatch",  "gsub", "len",    "lower",
                                        "match", "pack", "packsize", "rep",    "reverse", "sub",  "unpack", "upper"};
constexpr std::string_view kTable[] = {"concat", "insert", "move", "pack", "remove", "sort", "unpack"};
constexpr std::string_view kMath[] = {"abs",  "acos",       "asin",       "atan",      "ceil", "cos",    "deg",
                                      "exp",  "floor",      "fmod",       "huge",      "log",  "max",    "min",
                                      "modf", "maxinteger", "mininteger", "pi",        "rad",  "random", "randomseed",
                                      "sin",  "sqrt",       "tan",        "tointeger", "type", "ult"};
constexpr std::string_view kUtf8[] = {"char", "charpattern", "codepoint", "codes", "len", "offset"};
constexpr std::string_view kCoroutine[] = {"close",   "create", "isyieldable", "resume",
                                           "running", "status", "wrap",        "yield"};
constexpr std::string_view kDebug[] = {"traceback"};
constexpr std::string_view kOs[] = {"clock", "date", "difftime", "time"};
constexpr std::string_view kIo[] = {"close", "stdout", "stderr", "type"};

constexpr Library kLibraries[] = {{"string", kString},       {"table", kTable}, {"math", kMath}, {"utf8", kUtf8},
                                  {"coroutine", kCoroutine}, {"debug", kDebug}, {"os", kOs},     {"io", kIo}};

/// Pushes a new table with the kept entries of the table at `from`.
void push_kept(lua_State* L, int from, std::span<const std::string_view> kept) {
  from = lua_absindex(L, from);
  lua_createtable(L, 0, static_cast<int>(kept.size()));
  for (const std::string_view name : kept) {
    lua_pushlstring(L, name.data(), name.size());
    lua_pushvalue(L, -1);
    lua_rawget(L, from);
    lua_rawset(L, -3);
  }
}

/// Empties the table at `index` but for the names given.
void drop_others(lua_State* L, int index, std::span<const std::string_view> kept) {
  index = lua_absindex(L, index);
  for (lua_pushnil(L); lua_next(L, index);) {
    lua_pop(L, 1);
    const bool text = lua_type(L, -1) == LUA_TSTRING;
    if (text && std::find(kept.begin(), kept.end(), std::string_view(lua_tostring(L, -1))) != kept.end()) continue;
    lua_pushvalue(L, -1);
    lua_pushnil(L);
    lua_rawset(L, index);
  }
}

/// __index of a library: upvalue 1 is its name, upvalue 2 has the names that were dropped as keys.
int explain_missing(lua_State* L) {
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(2)) == LUA_TNIL) return 0;
  return luaL_error(L, "the sandbox has no %s.%s", lua_tostring(L, lua_upvalueindex(1)), lua_tostring(L, 2));
}

/// Gives the library on top a metatable that tells which functions of the original a sandbox has not.
void explain_dropped(lua_State* L, const char* name, int original) {
  const int kept = lua_gettop(L);
  lua_createtable(L, 0, 2);
  lua_pushstring(L, name);
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, original); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) continue;
    lua_pushvalue(L, -2);
    if (lua_rawget(L, kept) == LUA_TNIL) {
      lua_pushvalue(L, -3);
      lua_pushboolean(L, true);
      lua_rawset(L, -6);
    }
    lua_pop(L, 1);
  }
  lua_pushcclosure(L, explain_missing, 2);
  lua_setfield(L, -2, "__index");
  lua_pushliteral(L, "locked");
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, kept);
}

/// A library is a global and a loaded module; the old table is reachable by nothing any more.
void set_library(lua_State* L, const char* name, int loaded) {
  lua_pushvalue(L, -1);
  lua_setfield(L, loaded, name);
  lua_setglobal(L, name);
}

/// Methods of texts are those of the kept library.
void lock_strings(lua_State* L) {
  lua_pushliteral(L, "");
  lua_getmetatable(L, -1);
  lua_getglobal(L, "string");
  lua_setfield(L, -2, "__index");
  lua_pushliteral(L, "locked");
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 2);
}

}  // namespace

int call_original(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

void keep_safe_libraries(lua_State* L) {
  const int base = lua_gettop(L);
  lua_getfield(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  const int loaded = base + 1;
  for (const Library& library : kLibraries) lua_getglobal(L, library.name);
  lua_pushglobaltable(L);
  drop_others(L, -1, kBase);
  add_safe_base(L);
  lua_pop(L, 1);
  constexpr std::string_view kLoaded[] = {"_G"};
  drop_others(L, loaded, kLoaded);
  int original = loaded;
  for (const Library& library : kLibraries) {
    push_kept(L, ++original, library.kept);
    set_library(L, library.name, loaded);
  }
  lock_strings(L);
  lua_getglobal(L, "debug");
  add_safe_debug(L);
  add_safe_os(L, original - 1);
  add_safe_io(L, original);
  original = loaded;
  for (const Library& library : kLibraries) {
    lua_getglobal(L, library.name);
    explain_dropped(L, library.name, ++original);
    lua_pop(L, 1);
  }
  lua_settop(L, base);
}

}  // namespace meander::script
