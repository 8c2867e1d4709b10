// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/kit_module.hpp"

#include <lauxlib.h>

#include "script/kit_type.hpp"

namespace meander::script {
namespace {

const char kModuleType = 0;  ///< keys the metatable of modules in the registry
const char kRecords = 0;     ///< keys the table from functions and modules to their records

void push_records(lua_State* L) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &kRecords) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &kRecords);
}

/// Reading a name that a module does not have.
int missing_member(lua_State* L) {
  const Record* module = record_of(L, 1);
  if (!module || lua_type(L, 2) != LUA_TSTRING) return 0;
  const Record& record = *module;
  return border(L, record, [&]() -> int {
    std::vector<std::string> known;
    for (const Record* member : session(L).docs.members(record.name())) known.push_back(member->member);
    const std::string name = lua_tostring(L, 2);
    fail("has no member '{}'{} (known: {})", name.substr(0, 60), did_you_mean(name, known), listing(known));
  });
}

void push_module_type(lua_State* L) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &kModuleType) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  lua_pushcfunction(L, missing_member);
  lua_setfield(L, -2, "__index");
  lua_pushliteral(L, "module");
  lua_setfield(L, -2, "__name");
  lua_pushliteral(L, "locked");
  lua_setfield(L, -2, "__metatable");
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &kModuleType);
}

/// Pushes the table at a dotted path from the globals, raw, making what is missing.
void push_path(lua_State* L, const std::string& path) {
  lua_pushglobaltable(L);
  for (std::size_t from = 0; from < path.size();) {
    const std::size_t to = std::min(path.find('.', from), path.size());
    lua_pushlstring(L, path.data() + from, to - from);
    lua_pushvalue(L, -1);
    if (lua_rawget(L, -3) != LUA_TTABLE) {
      lua_pop(L, 1);
      lua_newtable(L);
      push_module_type(L);
      lua_setmetatable(L, -2);
      lua_pushvalue(L, -2);
      lua_pushvalue(L, -2);
      lua_rawset(L, -5);
    }
    lua_replace(L, -3);
    lua_pop(L, 1);
    from = to + 1;
  }
}

/// "meander.sim" is the member "sim" of "meander".
Record module_record(const std::string& path, const char* text) {
  const std::size_t dot = path.rfind('.');
  Record record{.kind = DocKind::module, .text = text};
  record.owner = dot == std::string::npos ? "" : path.substr(0, dot);
  record.member = dot == std::string::npos ? path : path.substr(dot + 1);
  return record;
}

}  // namespace

void remember_record(lua_State* L, const Record& record) {
  push_records(L);
  lua_pushvalue(L, -2);
  lua_pushlightuserdata(L, const_cast<Record*>(&record));
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

bool is_module(lua_State* L, int index) {
  if (!lua_istable(L, index) || !lua_getmetatable(L, index)) return false;
  push_module_type(L);
  const bool same = lua_rawequal(L, -1, -2);
  lua_pop(L, 2);
  return same;
}

const Record* record_of(lua_State* L, int index) {
  if (const Record* type = type_record(L, index)) return type;
  if (!lua_isfunction(L, index) && !lua_istable(L, index)) return nullptr;
  const int value = lua_absindex(L, index);
  push_records(L);
  lua_pushvalue(L, value);
  lua_rawget(L, -2);
  const auto* record = static_cast<const Record*>(lua_touserdata(L, -1));
  lua_pop(L, 2);
  return record;
}

Module::Module(lua_State* L, const char* path, const char* text) : L_(L), path_(path) {
  if (!*path || session(L).docs.find(path)) return;
  push_path(L, path);
  remember_record(L, session(L).docs.add(module_record(path, text)));
  lua_pop(L, 1);
}

void Module::add(Record record, lua_CFunction function) {
  push_path(L_, path_);
  const Record& kept = session(L_).docs.add(std::move(record));
  lua_pushstring(L_, kept.member.c_str());
  lua_pushlightuserdata(L_, const_cast<Record*>(&kept));
  lua_pushcclosure(L_, function, 1);
  remember_record(L_, kept);
  lua_rawset(L_, -3);
  lua_pop(L_, 1);
}

}  // namespace meander::script
