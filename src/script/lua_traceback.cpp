// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/lua_traceback.hpp"

#include <fmt/format.h>
#include <lauxlib.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "script/pretty.hpp"

namespace meander::script {
namespace {

constexpr int kFirstFrames = 8;
constexpr int kLastFrames = 3;

/// Lines of scripts only: neither bound functions nor the modules inside the program tell a user anything.
bool of_a_script(const lua_Debug& frame) {
  return *frame.what != 'C' && !std::string_view(frame.source).starts_with("=[meander.");
}

/// The name of a global function; Lua itself forgets it where the call is the last thing a function does.
std::string global_name(lua_State* L, lua_Debug& frame) {
  std::string name;
  lua_getinfo(L, "f", &frame);
  lua_pushglobaltable(L);
  for (lua_pushnil(L); name.empty() && lua_next(L, -2); lua_pop(L, 1))
    if (lua_rawequal(L, -1, -4) && lua_type(L, -2) == LUA_TSTRING) name = lua_tostring(L, -2);
  lua_settop(L, lua_gettop(L) - (name.empty() ? 2 : 3));
  return name;
}

std::string place_text(lua_State* L, lua_Debug& frame) {
  if (std::strcmp(frame.what, "main") == 0) return "at top level";
  const std::string name = frame.name ? frame.name : global_name(L, frame);
  if (name.empty()) return fmt::format("in the function of line {}", frame.linedefined);
  const bool method = std::strcmp(frame.namewhat, "method") == 0;
  return fmt::format("in {} '{}'", method ? "method" : "function", name);
}

/// Asking for level n costs n steps in Lua: a deep stack is measured by bisection and only its ends are looked at.
int stack_depth(lua_State* L) {
  lua_Debug frame;
  int below = 1, beyond = 1;
  while (lua_getstack(L, beyond, &frame)) below = beyond, beyond *= 2;
  while (below < beyond) {
    const int middle = below + (beyond - below) / 2;
    if (lua_getstack(L, middle, &frame))
      below = middle + 1;
    else
      beyond = middle;
  }
  return beyond;
}

void add_frames(lua_State* L, int from, int to, std::vector<std::string>& frames) {
  lua_Debug frame;
  for (int level = from; level < to && lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "Sln", &frame);
    if (of_a_script(frame))
      frames.push_back(fmt::format("{}:{}: {}", frame.short_src, frame.currentline, place_text(L, frame)));
  }
}

std::vector<std::string> script_frames(lua_State* L) {
  std::vector<std::string> frames;
  const int depth = stack_depth(L);
  const int resumed = std::max(1 + kFirstFrames, depth - kLastFrames);
  add_frames(L, 1, 1 + kFirstFrames, frames);
  if (resumed > 1 + kFirstFrames) frames.push_back(fmt::format("... {} more", resumed - 1 - kFirstFrames));
  add_frames(L, resumed, depth, frames);
  if (frames.size() < 2) frames.clear();
  return frames;
}

/// Argument 1 is an error value. No part of the message handler: a large table takes its time, and no hook would stop
/// it there.
int table_text(lua_State* L) {
  if (!push_pretty(L, "brief")) return lua_pushliteral(L, "error value is a table, not a text"), 1;
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  lua_pushfstring(L, "error value is a table: %s", lua_tostring(L, -1));
  return 1;
}

/// Upvalue 1 is the ErrorReport to fill. Turns the error value into its text, tables excepted: it need not be a string.
int on_error(lua_State* L) {
  auto& report = *static_cast<ErrorReport*>(lua_touserdata(L, lua_upvalueindex(1)));
  report.trace = script_frames(L);
  if (lua_isstring(L, 1)) return 1;
  if (luaL_getmetafield(L, 1, "__tostring") != LUA_TNIL)
    luaL_tolstring(L, 1, nullptr);
  else if (lua_isnil(L, 1))
    lua_pushliteral(L, "error without a message");
  else if (lua_istable(L, 1))
    lua_settop(L, 1);
  else
    lua_pushfstring(L, "error value is a %s, not a text", luaL_typename(L, 1));
  return 1;
}

/// A message that nobody would read to its end is cut: copies of it take memory that may be short.
std::string pop_message(lua_State* L) {
  constexpr std::size_t kMost = 64 << 10;
  std::size_t length = 0;
  const char* text = lua_tolstring(L, -1, &length);
  if (!text || length <= kMost) return pop_text(L);
  std::string message = fmt::format("{}... ({} bytes)", std::string_view(text, kMost), length);
  lua_pop(L, 1);
  return message;
}

}  // namespace

std::string pop_text(lua_State* L) {
  std::size_t length = 0;
  const char* text = lua_tolstring(L, -1, &length);
  const std::string result = text ? std::string(text, length) : std::string("error while handling an error");
  lua_pop(L, 1);
  return result;
}

std::string text_of(const ErrorReport& report) {
  std::string text = report.message;
  for (const std::string& frame : report.trace) text += "\n  " + frame;
  return text;
}

bool call_reporting(lua_State* L, int count, ErrorReport& report) {
  const int base = lua_gettop(L) - count;
  lua_pushlightuserdata(L, &report);
  lua_pushcclosure(L, on_error, 1);
  lua_insert(L, base);
  const bool done = lua_pcall(L, count, LUA_MULTRET, base) == LUA_OK;
  if (!done && lua_istable(L, -1)) {
    lua_pushcfunction(L, table_text);
    lua_insert(L, -2);
    lua_pcall(L, 1, 1, 0);  // an interrupt is a message too
  }
  if (!done) report.message = pop_message(L);
  lua_remove(L, base);
  return done;
}

}  // namespace meander::script
