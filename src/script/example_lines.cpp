// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/example_lines.hpp"

#include <lauxlib.h>

#include <memory>

namespace meander::script {
namespace {

bool compiles(lua_State* L, std::string_view lua) {
  const bool good = luaL_loadbufferx(L, lua.data(), lua.size(), "=example", "t") == LUA_OK;
  lua_pop(L, 1);
  return good;
}

/// What begins so goes on with what is in front: `f (x)`, `f {x}`, `f "x"`.
bool may_continue(char first) { return std::string_view("({[\"'.:").find(first) != std::string_view::npos; }

/// Where the first statement ends: the first gap where both sides are Lua.
std::size_t end_of_statement(lua_State* L, std::string_view text) {
  for (std::size_t at = text.find(' '); at != std::string_view::npos; at = text.find(' ', at + 1))
    if (!may_continue(text[at + 1]) && compiles(L, text.substr(0, at)) && compiles(L, text.substr(at + 1))) return at;
  return text.size();
}

}  // namespace

std::string example_lines(std::string_view example) {
  const std::unique_ptr<lua_State, void (*)(lua_State*)> L(luaL_newstate(), lua_close);
  if (!L || !compiles(L.get(), example)) return std::string(example);
  std::string lines;
  while (!example.empty()) {
    const std::size_t end = end_of_statement(L.get(), example);
    lines += (lines.empty() ? "" : "\n") + std::string(example.substr(0, end));
    example.remove_prefix(std::min(end + 1, example.size()));
  }
  return lines;
}

std::string indented(std::string_view text, std::string_view indent) {
  std::string result;
  for (const char c : text) {
    result += c;
    if (c == '\n') result += indent;
  }
  return result;
}

}  // namespace meander::script
