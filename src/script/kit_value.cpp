// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/kit_value.hpp"

#include <lauxlib.h>

#include <cmath>
#include <cstring>
#include <set>

namespace meander::script {
namespace {

constexpr std::size_t kLongestShown = 40;
const char kPointType = 0;  ///< its address keys the metatable of points and poses in the registry

std::string describe_scalar(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      if (lua_isinteger(L, index)) return fmt::format("{}", lua_tointeger(L, index));
      return std::isnan(lua_tonumber(L, index)) ? "nan" : fmt::format("{}", lua_tonumber(L, index));
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) ? "true" : "false";
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* text = lua_tolstring(L, index, &size);
      std::string shown;
      for (const char c : std::string_view(text, std::min(size, kLongestShown)))
        shown += static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
      return '"' + shown + (size > kLongestShown ? "...\"" : "\"");
    }
    default:
      return luaL_typename(L, index);
  }
}

/// "table {a = ..., b = ...}": sorted, because the order of Lua's tables changes from run to run.
std::string describe_keys(lua_State* L, int table) {
  constexpr std::size_t kMostShown = 3;
  std::set<std::string> keys;
  lua_pushnil(L);
  for (; lua_next(L, table); lua_pop(L, 1)) {
    keys.insert(lua_type(L, -2) == LUA_TSTRING ? std::string(lua_tostring(L, -2)).substr(0, kLongestShown) : "[...]");
    if (keys.size() > kMostShown) keys.erase(std::prev(keys.end()));
  }
  if (keys.empty()) return "{}";
  std::string text;
  for (const std::string& key : keys) text += (text.empty() ? "" : ", ") + key + " = ...";
  return "table {" + text + "}";
}

/// "{1, 2, ...}" of the list part, "{x = ...}" for others; raw access only.
std::string describe_table(lua_State* L, int table) {
  constexpr lua_Integer kMostShown = 4;
  std::string text;
  lua_Integer i = 1;
  for (; i <= kMostShown && lua_rawgeti(L, table, i) != LUA_TNIL; ++i, lua_pop(L, 1))
    text += (i > 1 ? ", " : "") + (lua_istable(L, -1) ? std::string("{...}") : describe_scalar(L, -1));
  if (i <= kMostShown) {
    lua_pop(L, 1);
    if (i > 1) return "{" + text + "}";
  } else {
    const bool more = lua_rawgeti(L, table, i) != LUA_TNIL;
    lua_pop(L, 1);
    return "{" + text + (more ? ", ...}" : "}");
  }
  return describe_keys(L, table);
}

int point_index(lua_State* L) {
  static const char* const names[] = {"x", "y", "heading"};
  if (lua_type(L, 2) == LUA_TSTRING)
    for (int i = 0; i < 3; ++i)
      if (!std::strcmp(lua_tostring(L, 2), names[i])) return lua_rawgeti(L, 1, i + 1), 1;
  return 0;
}

int point_tostring(lua_State* L) {
  std::string text = "{";
  if (lua_istable(L, 1))
    for (lua_Integer i = 1; lua_rawgeti(L, 1, i) == LUA_TNUMBER; ++i)
      text += fmt::format("{}{:.6g}", i > 1 ? ", " : "", lua_tonumber(L, -1)), lua_pop(L, 1);
  text += "}";
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

int point_equal(lua_State* L) {
  bool equal = lua_istable(L, 1) && lua_istable(L, 2);
  for (int i = 1; equal && i <= 3; ++i) {
    lua_rawgeti(L, 1, i);
    lua_rawgeti(L, 2, i);
    equal = lua_rawequal(L, -1, -2);
    lua_pop(L, 2);
  }
  lua_pushboolean(L, equal);
  return 1;
}

void push_point_type(lua_State* L) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &kPointType) == LUA_TTABLE) return;
  lua_pop(L, 1);
  const luaL_Reg functions[] = {
      {"__index", point_index}, {"__tostring", point_tostring}, {"__eq", point_equal}, {nullptr, nullptr}};
  luaL_newlib(L, functions);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &kPointType);
}

bool is_point(lua_State* L, int index) {
  if (!lua_getmetatable(L, index)) return false;
  push_point_type(L);
  const bool same = lua_rawequal(L, -1, -2);
  lua_pop(L, 2);
  return same;
}

bool finite_number(lua_State* L, double& out) {
  const bool ok = lua_type(L, -1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1));
  if (ok) out = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return ok;
}

}  // namespace

std::string Path::text() const {
  std::string inner;
  const Path* at = this;
  for (; at->parent; at = at->parent) {
    if (at->kind == Kind::element)
      inner = fmt::format("[{}]{}{}", at->index, inner.empty() || inner[0] == '[' ? "" : ".", inner);
    else
      inner = at->name + (inner.empty() || inner[0] == '[' ? inner : "." + inner);
  }
  if (at->kind == Kind::self) return "self";
  if (at->kind == Kind::value) return at->name + (inner.empty() ? "" : " '" + inner + "'");
  if (!inner.empty() && inner[0] != '[') return "option '" + inner + "'";
  const auto number = static_cast<std::size_t>(at->index);
  const std::string name =
      at->record && number < at->record->arguments.size() ? at->record->arguments[number].name : "?";
  return fmt::format("argument {} ('{}{}')", number + 1, name, inner);
}

std::string describe(lua_State* L, int index) {
  luaL_checkstack(L, 4, nullptr);
  const int at = lua_absindex(L, index);
  switch (lua_type(L, at)) {
    case LUA_TNONE:
      return "nothing";
    case LUA_TNUMBER:
    case LUA_TBOOLEAN:
    case LUA_TSTRING:
      return std::string(luaL_typename(L, at)) + " " + describe_scalar(L, at);
    case LUA_TTABLE:
    case LUA_TUSERDATA:
      if (luaL_getmetafield(L, at, "__name") == LUA_TSTRING) {
        const std::string name = lua_tostring(L, -1);
        lua_pop(L, 1);
        return name;
      }
      return lua_istable(L, at) ? describe_table(L, at) : "userdata";
    default:
      return luaL_typename(L, at);
  }
}

void expected(lua_State* L, int index, const Path& path, std::string_view what) {
  fail("{}: {} expected, got {}", path.text(), what, describe(L, index));
}

void unknown_value(const Path& path, std::string_view value, const std::vector<std::string>& known) {
  std::string names;
  for (const std::string& name : known) names += (names.empty() ? "'" : ", '") + name + "'";
  fail("{}: unknown value '{}', one of {}{}", path.text(), value.substr(0, kLongestShown), names,
       did_you_mean(value, known));
}

double read_number(lua_State* L, int index, const Path& path) {
  if (lua_type(L, index) != LUA_TNUMBER) expected(L, index, path, "number");
  const double number = lua_tonumber(L, index);
  if (!std::isfinite(number)) expected(L, index, path, "finite number");
  return number;
}

lua_Integer read_integer(lua_State* L, int index, const Path& path, lua_Integer least, lua_Integer most) {
  int whole = 0;
  const lua_Integer number = lua_type(L, index) == LUA_TNUMBER ? lua_tointegerx(L, index, &whole) : 0;
  if (!whole) expected(L, index, path, "integer");
  if (number < least && least == 0) fail("{}: an integer from 0 on expected, got {}", path.text(), number);
  if (number < least || number > most) fail("{}: integer {} out of range", path.text(), number);
  return number;
}

std::string_view read_text(lua_State* L, int index, const Path& path) {
  if (lua_type(L, index) != LUA_TSTRING) expected(L, index, path, "string");
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  return {text, size};
}

void read_numbers(lua_State* L, int index, const Path& path, const char* const* names, int count, int spare,
                  double* out, std::string_view what) {
  if (!lua_istable(L, index)) expected(L, index, path, what);
  const int table = lua_absindex(L, index);
  const auto length = static_cast<int>(std::min<lua_Unsigned>(lua_rawlen(L, table), 16));
  const bool list = length > 0;
  // A pose is taken where a point is asked for.
  if (length > count && !is_point(L, table)) expected(L, table, path, what);
  for (int i = 0; i < count; ++i) {
    if (list)
      lua_rawgeti(L, table, i + 1);
    else
      lua_pushstring(L, names[i]), lua_rawget(L, table);
    if (lua_isnil(L, -1) && i >= count - spare) {
      out[i] = 0;
      lua_pop(L, 1);
    } else if (!finite_number(L, out[i])) {
      expected(L, table, path, what);
    }
  }
}

void push_point(lua_State* L, const double* numbers, int count) {
  lua_createtable(L, count, 0);
  for (int i = 0; i < count; ++i) {
    lua_pushnumber(L, numbers[i]);
    lua_rawseti(L, -2, i + 1);
  }
  push_point_type(L);
  lua_setmetatable(L, -2);
}

Vec2 Lua<Vec2>::read(lua_State* L, int index, const Path& path) {
  static const char* const names[] = {"x", "y"};
  Vec2 point;
  read_numbers(L, index, path, names, 2, 0, point.data(), "{x, y}");
  return point;
}

Pose2 Lua<Pose2>::read(lua_State* L, int index, const Path& path) {
  static const char* const names[] = {"x", "y", "heading"};
  double numbers[3];
  read_numbers(L, index, path, names, 3, 1, numbers, "{x, y, heading}");
  return {numbers[0], numbers[1], wrap_angle(numbers[2])};
}

void Lua<Pose2>::push(lua_State* L, const Pose2& value) {
  const double numbers[] = {value.x, value.y, value.heading};
  push_point(L, numbers, 3);
}

Box Lua<Box>::read(lua_State* L, int index, const Path& path) {
  const std::vector<Vec2> corners = Lua<std::vector<Vec2>>::read(L, index, path);
  if (corners.size() != 2) expected(L, index, path, type());
  return {corners[0], corners[1]};
}

void Lua<Box>::push(lua_State* L, const Box& value) { script::push(L, std::vector<Vec2>{value.low, value.high}); }

Size Lua<Size>::read(lua_State* L, int index, const Path& path) {
  static const char* const names[] = {"width", "height"};
  double numbers[2];
  read_numbers(L, index, path, names, 2, 0, numbers, type());
  return {numbers[0], numbers[1]};
}

}  // namespace meander::script
