// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "base/fields.hpp"
#include "geometry/pose.hpp"
#include "script/docs.hpp"

namespace meander::script {

/// Names the value that is being read, for messages: a chain from argument to option to element that lives on the stack
/// of the readers and costs nothing until something is wrong.
struct Path {
  enum class Kind { self, argument, option, element, value };
  Kind kind;
  const char* name = nullptr;      ///< of an option, or what stands for another value in messages
  lua_Integer index = 0;           ///< of an argument (0 first) or an element (1 first)
  const Path* parent = nullptr;    ///< of options and elements
  const Record* record = nullptr;  ///< of arguments: their names

  /// "self", "argument 2 ('name')", "option 'sonar.noise'", "option 'subgoals[3]'".
  std::string text() const;
};

/// "number 3", "string \"abc\"", "{1, 2, 3}", "nothing": what a script gave, without running any of its code.
std::string describe(lua_State* L, int index);

/// Throws "<path>: <what> expected, got <value>".
[[noreturn]] void expected(lua_State* L, int index, const Path& path, std::string_view what);
/// Throws "<path>: unknown value '<value>', one of 'a', 'b'; did you mean 'a'?".
[[noreturn]] void unknown_value(const Path& path, std::string_view value, const std::vector<std::string>& known);

/// How a C++ type T crosses the border:
///   static T read(lua_State* L, int index, const Path& path);  throws ArgumentError
///   static void push(lua_State* L, const T& value);            one value
///   static std::string type();                                 for people: "number", "{x, y}"
/// A specialisation needs only the directions that are used.
template <class T>
struct Lua;

template <class T>
void push(lua_State* L, const T& value) {
  Lua<T>::push(L, value);
}

double read_number(lua_State* L, int index, const Path& path);
lua_Integer read_integer(lua_State* L, int index, const Path& path, lua_Integer least, lua_Integer most);
std::string_view read_text(lua_State* L, int index, const Path& path);
/// `count` finite numbers from {a, b} or {x = a, y = b}; the last `spare` of them may be missing (0).
void read_numbers(lua_State* L, int index, const Path& path, const char* const* names, int count, int spare,
                  double* out, std::string_view what);
/// A list {a, b} that also answers to .x, .y (and .heading).
void push_point(lua_State* L, const double* numbers, int count);

template <>
struct Lua<double> {
  static double read(lua_State* L, int index, const Path& path) { return read_number(L, index, path); }
  static void push(lua_State* L, double value) { lua_pushnumber(L, value); }
  static std::string type() { return "number"; }
};

template <>
struct Lua<bool> {
  static bool read(lua_State* L, int index, const Path& path) {
    if (!lua_isboolean(L, index)) expected(L, index, path, "boolean");
    return lua_toboolean(L, index);
  }
  static void push(lua_State* L, bool value) { lua_pushboolean(L, value); }
  static std::string type() { return "boolean"; }
};

template <>
struct Lua<int> {
  static int read(lua_State* L, int index, const Path& path) {
    return static_cast<int>(read_integer(L, index, path, INT32_MIN, INT32_MAX));
  }
  static void push(lua_State* L, int value) { lua_pushinteger(L, value); }
  static std::string type() { return "integer"; }
};

/// 64-bit words (seeds): Lua's integers are signed, and no seed below 0 is taken, which would be shown as another one.
template <>
struct Lua<std::uint64_t> {
  static std::uint64_t read(lua_State* L, int index, const Path& path) {
    return static_cast<std::uint64_t>(read_integer(L, index, path, 0, LUA_MAXINTEGER));
  }
  static void push(lua_State* L, std::uint64_t value) { lua_pushinteger(L, static_cast<lua_Integer>(value)); }
  static std::string type() { return "integer"; }
};

template <>
struct Lua<std::string> {
  static std::string read(lua_State* L, int index, const Path& path) { return std::string(read_text(L, index, path)); }
  static void push(lua_State* L, std::string_view value) { lua_pushlstring(L, value.data(), value.size()); }
  static std::string type() { return "string"; }
};

template <NamedEnum E>
struct Lua<E> {
  static E read(lua_State* L, int index, const Path& path) {
    const std::string_view text = read_text(L, index, path);
    const std::optional<E> value = enum_from<E>(text);
    if (!value) unknown_value(path, text, enum_names<E>());
    return *value;
  }
  static void push(lua_State* L, E value) { lua_pushstring(L, to_string(value)); }
  static std::string type() {
    std::string text;
    for (const std::string& name : enum_names<E>()) text += (text.empty() ? "'" : " | '") + name + "'";
    return text;
  }
};

template <>
struct Lua<Vec2> {
  static Vec2 read(lua_State* L, int index, const Path& path);
  static void push(lua_State* L, const Vec2& value) { push_point(L, value.data(), 2); }
  static std::string type() { return "{x, y}"; }
};

template <>
struct Lua<Pose2> {
  static Pose2 read(lua_State* L, int index, const Path& path);
  static void push(lua_State* L, const Pose2& value);
  static std::string type() { return "{x, y, heading}"; }
};

/// {{x, y}, {x, y}}: lower left and upper right corner.
template <>
struct Lua<Box> {
  static Box read(lua_State* L, int index, const Path& path);
  static void push(lua_State* L, const Box& value);
  static std::string type() { return "{{x, y}, {x, y}}"; }
};

/// Extent along x and y [m].
struct Size {
  double width = 0;
  double height = 0;
};
template <>
struct Lua<Size> {
  static Size read(lua_State* L, int index, const Path& path);
  static std::string type() { return "{width, height}"; }
};

template <class T>
struct Lua<std::optional<T>> {
  static std::optional<T> read(lua_State* L, int index, const Path& path) {
    if (lua_isnoneornil(L, index)) return std::nullopt;
    return Lua<T>::read(L, index, path);
  }
  static void push(lua_State* L, const std::optional<T>& value) {
    if (value)
      Lua<T>::push(L, *value);
    else
      lua_pushnil(L);
  }
  static std::string type() { return Lua<T>::type(); }
};

template <class T>
struct Lua<std::vector<T>> {
  static std::vector<T> read(lua_State* L, int index, const Path& path) {
    if (!lua_istable(L, index)) expected(L, index, path, type());
    const int table = lua_absindex(L, index);
    std::vector<T> list;
    for (lua_Integer i = 1; lua_rawgeti(L, table, i) != LUA_TNIL; ++i) {
      list.push_back(Lua<T>::read(L, -1, Path{.kind = Path::Kind::element, .index = i, .parent = &path}));
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
    if (list.empty() && lua_next_exists(L, table)) expected(L, table, path, type());
    return list;
  }
  static void push(lua_State* L, const std::vector<T>& list) {
    lua_createtable(L, static_cast<int>(list.size()), 0);
    lua_Integer i = 0;
    for (const T& value : list) {
      Lua<T>::push(L, value);
      lua_rawseti(L, -2, ++i);
    }
  }
  static std::string type() { return "list of " + Lua<T>::type(); }

 private:
  /// {x = 1} is no list: say so instead of reading it as an empty one.
  static bool lua_next_exists(lua_State* L, int table) {
    lua_pushnil(L);
    if (lua_next(L, table) == 0) return false;
    lua_pop(L, 2);
    return true;
  }
};

/// Names to values, as a table.
template <class T>
struct Lua<std::map<std::string, T>> {
  static void push(lua_State* L, const std::map<std::string, T>& values) {
    lua_createtable(L, 0, static_cast<int>(values.size()));
    for (const auto& [name, value] : values) {
      Lua<T>::push(L, value);
      lua_setfield(L, -2, name.c_str());
    }
  }
  static std::string type() { return "table of " + Lua<T>::type(); }
};

/// One of several types.
template <class... T>
struct Lua<std::variant<T...>> {
  static void push(lua_State* L, const std::variant<T...>& value) {
    std::visit([&](const auto& v) { script::push(L, v); }, value);
  }
};

/// Several results: they are several values in Lua too.
template <class... T>
struct Lua<std::tuple<T...>> {
  static void push(lua_State* L, const std::tuple<T...>& values) {
    std::apply([&](const T&... value) { (Lua<T>::push(L, value), ...); }, values);
  }
  static std::string type() {
    std::string text;
    ((text += (text.empty() ? "" : ", ") + Lua<T>::type()), ...);
    return text;
  }
};

}  // namespace meander::script
