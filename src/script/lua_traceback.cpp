// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/lua_traceback.hpp"

#include <fmt/format.h>
#include <lauxlib.h>

#include <cstring>
#include <string_view>

namespace meander::script {
namespace {

constexpr std::size_t kShownFrames = 12;

/// Lines of scripts only: neither bound functions nor the modules inside the program tell a user anything.
bool of_a_script(const lua_Debug& frame) {
  return *frame.what != 'C' && !std::string_view(frame.source).starts_with("=[meander.");
}

std::string place_text(const lua_Debug& frame) {
  if (std::strcmp(frame.what, "main") == 0) return "at top level";
  if (frame.name) return fmt::format("in {} '{}'", *frame.namewhat ? frame.namewhat : "function", frame.name);
  return fmt::format("in the function of line {}", frame.linedefined);
}

std::vector<std::string> script_frames(lua_State* L) {
  std::vector<std::string> frames;
  std::size_t hidden = 0;
  lua_Debug frame;
  for (int level = 1; lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "Sln", &frame);
    if (!of_a_script(frame)) continue;
    if (frames.size() < kShownFrames)
      frames.push_back(fmt::format("{}:{}: {}", frame.short_src, frame.currentline, place_text(frame)));
    else
      ++hidden;
  }
  if (hidden) frames.push_back(fmt::format("... and {} more", hidden));
  if (frames.size() < 2) frames.clear();
  return frames;
}

/// Upvalue 1 is the ErrorReport to fill. Turns the error value into its text: it need not be a string.
int on_error(lua_State* L) {
  auto& report = *static_cast<ErrorReport*>(lua_touserdata(L, lua_upvalueindex(1)));
  report.trace = script_frames(L);
  if (lua_isstring(L, 1)) return 1;
  if (luaL_getmetafield(L, 1, "__tostring") != LUA_TNIL)
    luaL_tolstring(L, 1, nullptr);
  else
    lua_pushfstring(L, "error value is a %s, not a text", luaL_typename(L, 1));
  return 1;
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
  if (!done) report.message = pop_text(L);
  lua_remove(L, base);
  return done;
}

}  // namespace meander::script
