// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/command_argument.hpp"

namespace meander::script {
namespace {

/// {v = 0.3, w = 0} or {0.3, 0}
Command read_command(lua_State* L, int index, const Path& path) {
  if (lua_istable(L, index) && lua_rawlen(L, index) > 0) {
    static const char* const names[] = {"v", "w"};
    double numbers[2];
    read_numbers(L, index, path, names, 2, 0, numbers, "{v, w}");
    return {numbers[0], numbers[1], 0};
  }
  return Lua<Command>::read(L, index, path);
}

}  // namespace

std::vector<Command> CommandArgument::for_robots(std::size_t count, const std::optional<double>& w) const {
  if (w && !v) fail("argument 2 ('w'): only after a speed");
  const std::vector<Command> list = v ? std::vector<Command>{{*v, w.value_or(0), 0}} : commands;
  if (list.size() != count)
    fail("{} command{} expected, one per robot, got {}", count, count == 1 ? "" : "s", list.size());
  return list;
}

CommandArgument Lua<CommandArgument>::read(lua_State* L, int index, const Path& path) {
  if (lua_type(L, index) == LUA_TNUMBER) return {read_number(L, index, path), {}};
  if (!lua_istable(L, index)) expected(L, index, path, type());
  const bool list = lua_rawgeti(L, index, 1) == LUA_TTABLE;
  lua_pop(L, 1);
  if (!list) return {{}, {read_command(L, index, path)}};
  CommandArgument argument;
  for (lua_Integer i = 1; lua_rawgeti(L, index, i) != LUA_TNIL; ++i, lua_pop(L, 1))
    argument.commands.push_back(read_command(L, -1, Path{.kind = Path::Kind::element, .index = i, .parent = &path}));
  lua_pop(L, 1);
  return argument;
}

}  // namespace meander::script
