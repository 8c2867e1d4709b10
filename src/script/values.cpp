// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/values.hpp"

namespace meander::script {

Drawn Lua<Drawn>::read(lua_State* L, int index, const Path& path) {
  if (!lua_istable(L, index)) return {Lua<Values>::read(L, index, path).list};
  const int table = lua_absindex(L, index);
  Drawn drawn;
  for (lua_Integer i = 1; lua_rawgeti(L, table, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
    if (lua_type(L, -1) != LUA_TNUMBER)
      expected(L, -1, Path{.kind = Path::Kind::element, .index = i, .parent = &path}, "number");
    drawn.list.push_back(lua_tonumber(L, -1));
  }
  lua_pop(L, 1);
  return drawn;
}

Rows Lua<Rows>::read(lua_State* L, int index, const Path& path) {
  if (!is_nested(L, index)) return {*read_object<Matrix>(L, index, path)};
  const auto rows = Lua<std::vector<Drawn>>::read(L, index, path);
  auto cells = std::make_shared<std::vector<float>>();
  const std::size_t columns = rows.front().list.size();
  for (const Drawn& row : rows) {
    if (row.list.size() != columns) fail("rows of equal length expected, got {} and {}", columns, row.list.size());
    cells->insert(cells->end(), row.list.begin(), row.list.end());
  }
  return {{std::move(cells), rows.size(), columns}};
}

bool is_nested(lua_State* L, int index) {
  if (!lua_istable(L, index)) return false;
  const bool nested = lua_rawgeti(L, index, 1) == LUA_TTABLE;
  lua_pop(L, 1);
  return nested;
}

}  // namespace meander::script
