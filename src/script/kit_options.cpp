// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/kit_options.hpp"

#include <algorithm>
#include <optional>

namespace meander::script {
namespace {

std::string name_of_option(const Path& path, std::string_view key) {
  return "'" + option_prefix(path) + std::string(key) + "'";
}

}  // namespace

std::string option_prefix(const Path& path) {
  if (path.kind == Path::Kind::argument || path.kind == Path::Kind::self) return {};
  const std::string text = path.text();  // "option 'a.b'"
  const auto from = text.find('\'');
  return text.substr(from + 1, text.rfind('\'') - from - 1) + ".";
}

void check_keys(lua_State* L, int table, const Path& path, const std::vector<std::string>& known) {
  std::optional<std::string> unknown;  // the first by name: the order of Lua's tables changes from run to run
  lua_pushnil(L);
  for (; lua_next(L, table); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      fail("options by name expected, got {} without a name (known: {})", describe(L, -1), listing(known));
    std::string key = lua_tostring(L, -2);
    const bool fits = std::find(known.begin(), known.end(), key) != known.end();
    if (!fits && (!unknown || key < *unknown)) unknown = std::move(key);
  }
  if (unknown)
    fail("unknown option {}{} (known: {})", name_of_option(path, unknown->substr(0, 60)), did_you_mean(*unknown, known),
         listing(known));
}

void push_option(lua_State* L, int table, const char* name) {
  lua_pushstring(L, name);
  lua_rawget(L, table);
}

}  // namespace meander::script
