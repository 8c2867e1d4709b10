// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>
#include <lua.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <string>
#include <vector>

#include "base/names.hpp"
#include "script/lua_setup.hpp"

namespace meander::script {
namespace {

constexpr int kDeclared = lua_upvalueindex(1);
/// Of a table in the registry: names that only the prompt takes as they were typed, and the line that declares each.
constexpr const char* kDeclarations = "meander.declarations";

enum class Place { host, top_level, inside_function, prompt };

/// Where the code stands that reads or assigns the global.
Place place_of_access(lua_State* L) {
  lua_Debug activation;
  if (!lua_getstack(L, 1, &activation)) return Place::host;
  lua_getinfo(L, "S", &activation);
  if (std::strcmp(activation.source, kPromptChunk) == 0) return Place::prompt;
  if (*activation.what == 'C') return Place::host;
  return std::strcmp(activation.what, "main") == 0 ? Place::top_level : Place::inside_function;
}

void add_string_keys(lua_State* L, int table, std::vector<std::string>& names) {
  table = lua_absindex(L, table);
  for (lua_pushnil(L); lua_next(L, table); lua_pop(L, 1))
    if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -2));
}

/// Locals and upvalues of the function that reads: a misspelt local looks like a global.
void add_visible_locals(lua_State* L, std::vector<std::string>& names) {
  lua_Debug activation;
  if (!lua_getstack(L, 1, &activation)) return;
  for (int i = 1; const char* name = lua_getlocal(L, &activation, i); ++i, lua_pop(L, 1))
    if (*name != '(') names.emplace_back(name);
  lua_getinfo(L, "f", &activation);
  for (int i = 1; const char* name = lua_getupvalue(L, -1, i); ++i, lua_pop(L, 1)) names.emplace_back(name);
  lua_pop(L, 1);
}

/// What to say behind "undeclared variable 'x'".
std::string advice(lua_State* L, const std::string& name, Place place) {
  std::vector<std::string> names;
  lua_getglobal(L, "meander");
  if (lua_istable(L, -1)) {
    lua_pushstring(L, name.c_str());
    if (lua_rawget(L, -2) != LUA_TNIL) return "; did you mean 'meander." + name + "'?";
    lua_pop(L, 1);
    if (place == Place::prompt) add_string_keys(L, -1, names);
  }
  if (name.size() == 1) return {};  // every other letter is as near
  add_visible_locals(L, names);
  lua_pushglobaltable(L);
  add_string_keys(L, -1, names);
  return did_you_mean(name, names);
}

/// Keeps "<name> = <value>" unless there is a line for this name.
void remember_declaration(lua_State* L, int name, const std::string& value) {
  name = lua_absindex(L, name);
  lua_getfield(L, LUA_REGISTRYINDEX, kDeclarations);
  lua_pushvalue(L, name);
  if (lua_rawget(L, -2) == LUA_TNIL) {
    lua_pushvalue(L, name);
    lua_pushfstring(L, "%s = %s", lua_tostring(L, name), value.c_str());
    lua_rawset(L, -4);
  }
  lua_pop(L, 2);
}

/// Pushes the module `meander.<name>`, which is a plain name at the prompt.
bool push_module(lua_State* L, int name) {
  lua_getglobal(L, "meander");
  if (!lua_istable(L, -1)) return false;
  lua_pushvalue(L, name);
  if (lua_rawget(L, -2) == LUA_TNIL) return false;
  remember_declaration(L, name, std::string("meander.") + lua_tostring(L, name));
  return true;
}

int read_undeclared(lua_State* L) {
  lua_pushvalue(L, 2);
  if (lua_rawget(L, kDeclared) != LUA_TNIL) return 0;
  const Place place = place_of_access(L);
  if (place == Place::prompt && push_module(L, 2)) return 1;
  if (place == Place::host || lua_type(L, 2) != LUA_TSTRING) return 0;
  const std::string name = lua_tostring(L, 2);
  return luaL_error(L, "undeclared variable '%s'%s", name.c_str(), advice(L, name, place).c_str());
}

/// A name as in `name = 1`, and not only a key as in `_G["a b"] = 1`.
bool is_name(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TSTRING) return false;
  const std::string text = lua_tostring(L, index);
  const bool plain = std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!plain) return false;
  const bool name = luaL_loadstring(L, ("local " + text).c_str()) == LUA_OK;  // no number and no keyword
  lua_pop(L, 1);
  return name;
}

bool in_main_chunk(lua_State* L) {
  lua_Debug activation;
  return lua_getstack(L, 1, &activation) && lua_getinfo(L, "S", &activation) &&
         std::strcmp(activation.what, "main") == 0;
}

int assign_undeclared(lua_State* L) {
  lua_pushvalue(L, 2);
  const bool declared = lua_rawget(L, kDeclared) != LUA_TNIL;
  const Place place = declared ? Place::host : place_of_access(L);
  if (place == Place::prompt && !in_main_chunk(L) && is_name(L, 2)) remember_declaration(L, 2, "nil");
  if (place == Place::inside_function && lua_type(L, 2) == LUA_TSTRING)
    return luaL_error(
        L,
        "assignment to undeclared variable '%s' inside a function; write 'local %s', or assign it first at "
        "the top level of the script",
        lua_tostring(L, 2), lua_tostring(L, 2));
  lua_pushvalue(L, 2);
  lua_pushboolean(L, true);
  lua_rawset(L, kDeclared);
  lua_settop(L, 3);
  lua_rawset(L, 1);
  return 0;
}

}  // namespace

void open_strict(lua_State* L) {
  lua_newtable(L);
  lua_setfield(L, LUA_REGISTRYINDEX, kDeclarations);
  lua_pushglobaltable(L);
  lua_createtable(L, 0, 3);
  lua_newtable(L);
  const luaL_Reg functions[] = {{"__index", read_undeclared}, {"__newindex", assign_undeclared}, {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 1);
  lua_pushliteral(L, "strict");
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

std::vector<std::string> declarations(lua_State* L) {
  std::vector<std::string> lines;
  lua_getfield(L, LUA_REGISTRYINDEX, kDeclarations);
  for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) lines.emplace_back(lua_tostring(L, -1));
  lua_pop(L, 1);
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace meander::script
