// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/numbers.hpp"

namespace meander::script {

/// A sample: a list of numbers, or a view of native ones.
struct Values {
  std::vector<double> list;
};
template <>
struct Lua<Values> {
  static Values read(lua_State* L, int index, const Path& path) {
    if (!test_box(L, index, tag_of<Numbers>)) return {Lua<std::vector<double>>::read(L, index, path)};
    const auto numbers = read_object<Numbers>(L, index, path);
    Values values{std::vector<double>(numbers->size())};
    for (std::size_t i = 0; i < values.list.size(); ++i) values.list[i] = (*numbers)[i];
    return values;
  }
  static std::string type() { return "list of numbers"; }
};

/// What is drawn: numbers that are not finite are gaps.
struct Drawn {
  std::vector<double> list;
};
template <>
struct Lua<Drawn> {
  static Drawn read(lua_State* L, int index, const Path& path);
  static std::string type() { return Lua<Values>::type(); }
};

/// A matrix, or a list of its rows.
struct Rows {
  Matrix matrix;
};
template <>
struct Lua<Rows> {
  static Rows read(lua_State* L, int index, const Path& path);
  static std::string type() { return "matrix or list of list of number"; }
};
/// The value at `index` is a list whose first element is a list, too.
bool is_nested(lua_State* L, int index);

}  // namespace meander::script
