// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/pack.hpp"

#include <lauxlib.h>

#include <nlohmann/json.hpp>

#include "script/objects.hpp"
#include "study/run_file.hpp"

namespace meander::script {
namespace {

using Json = nlohmann::json;
constexpr int kDeepest = 64;

Json to_json(lua_State* L, int index, int depth);

Json key_of(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TSTRING)
    fail("results with keys that are strings or 1 to n expected, got the key {}", describe(L, index));
  return std::string(lua_tostring(L, index), lua_rawlen(L, index));
}

bool in_list(lua_State* L, int key, lua_Unsigned size) {
  // 0 and negative keys become larger than any size.
  return lua_isinteger(L, key) && static_cast<lua_Unsigned>(lua_tointeger(L, key)) - 1 < size;
}

Json table_json(lua_State* L, int table, int depth) {
  if (depth > kDeepest) fail("results nested at most {} tables deep expected", kDeepest);
  luaL_checkstack(L, 4, nullptr);
  const lua_Unsigned size = lua_rawlen(L, table);
  Json list = Json::array(), object = Json::object();
  for (lua_Unsigned i = 1; i <= size; ++i, lua_pop(L, 1)) {
    lua_rawgeti(L, table, static_cast<lua_Integer>(i));
    list.push_back(to_json(L, -1, depth + 1));
  }
  lua_pushnil(L);
  for (; lua_next(L, table); lua_pop(L, 1))
    if (!in_list(L, -2, size)) object[key_of(L, -2)] = to_json(L, -1, depth + 1);
  if (!list.empty() && !object.empty()) fail("results that are lists or have keys by name expected, got both in one");
  return object.empty() ? list : object;
}

Json to_json(lua_State* L, int index, int depth) {
  const int at = lua_absindex(L, index);
  switch (lua_type(L, at)) {
    case LUA_TNONE:
    case LUA_TNIL:
      return nullptr;
    case LUA_TBOOLEAN:
      return static_cast<bool>(lua_toboolean(L, at));
    case LUA_TNUMBER:
      if (lua_isinteger(L, at)) return lua_tointeger(L, at);
      return lua_tonumber(L, at);
    case LUA_TSTRING:
      return std::string(lua_tostring(L, at), lua_rawlen(L, at));
    case LUA_TTABLE:
      return table_json(L, at, depth);
    default:
      if (const ObjectBox* box = test_box(L, at, tag_of<RunRecord>); box && box->object)
        return Json::parse(summary_json(static_cast<const RunRecord*>(box->object.get())->run));
      fail("results of numbers, texts, booleans, tables or runs expected, got {}", describe(L, at));
  }
}

void push_json(lua_State* L, const Json& json) {
  luaL_checkstack(L, 4, nullptr);
  if (json.is_boolean()) {
    lua_pushboolean(L, json.get<bool>());
  } else if (json.is_number_integer()) {
    lua_pushinteger(L, json.get<lua_Integer>());
  } else if (json.is_number()) {
    lua_pushnumber(L, json.get<double>());
  } else if (json.is_string()) {
    push(L, json.get<std::string>());
  } else if (json.is_array()) {
    lua_createtable(L, static_cast<int>(json.size()), 0);
    lua_Integer i = 0;
    for (const Json& element : json) push_json(L, element), lua_rawseti(L, -2, ++i);
  } else if (json.is_object()) {
    lua_createtable(L, 0, static_cast<int>(json.size()));
    for (const auto& [key, value] : json.items()) {
      lua_pushlstring(L, key.data(), key.size());
      push_json(L, value);
      lua_rawset(L, -3);
    }
  } else {
    lua_pushnil(L);
  }
}

}  // namespace

std::string pack(lua_State* L, int index) {
  // CBOR keeps integers apart from other numbers, and knows nan and infinity.
  const std::vector<std::uint8_t> bytes = Json::to_cbor(to_json(L, index, 0));
  return {bytes.begin(), bytes.end()};
}

void unpack(lua_State* L, const std::string& bytes) { push_json(L, Json::from_cbor(bytes)); }

}  // namespace meander::script
