// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/kit_call.hpp"

#include <lauxlib.h>

#include <cstdlib>
#include <new>

#include "script/kit_module.hpp"

namespace meander::script {
namespace {

/// "demo.lua:3: " of the nearest script line; calls by way of pcall or a metamethod have C functions in between.
std::string script_position(lua_State* L) {
  lua_Debug frame;
  for (int level = 1; lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline > 0) return fmt::format("{}:{}: ", frame.short_src, frame.currentline);
  }
  return {};
}

/// The beginner's slip behind the problem, if it looks like one. An object may have taken the name of its module.
std::string slip(lua_State* L, const Record& record, const std::string& problem) {
  if (record.kind == DocKind::method && problem.starts_with("self: ") &&
      problem.find("expected") != std::string::npos) {
    const Record* namesake = session(L).docs.find("meander." + record.owner + "." + record.member);
    return namesake ? fmt::format(" (call it with ':', or {} of the module)", namesake->name()) : " (call it with ':')";
  }
  if (record.kind == DocKind::function && is_module(L, 1)) return " (call it with '.')";
  return "";
}

}  // namespace

void raise(lua_State* L, const Record& record, const std::string& problem) {
  luaL_checkstack(L, 8, nullptr);
  const bool memory = problem == std::bad_alloc().what() || problem == std::bad_array_new_length().what();
  const std::string text =
      script_position(L) + record.name() + ": " + (memory ? "not enough memory" : problem) + slip(L, record, problem);
  lua_pushlstring(L, text.data(), text.size());
  lua_error(L);
  std::abort();  // lua_error does not return
}

void raise_interrupted(lua_State* L) {
  lua_pushstring(L, kInterrupted);
  lua_error(L);
  std::abort();
}

void too_many_arguments(int most, int given) {
  if (most == 0) fail("takes no arguments, got {}", given);
  fail("takes {} argument{} at most, got {}", most, most == 1 ? "" : "s", given);
}

}  // namespace meander::script
