// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <gtest/gtest.h>
#include <lauxlib.h>
#include <lualib.h>

#include <string>

#include "script/session.hpp"

namespace meander::script {

/// A bare Lua state with the standard libraries and a session.
class ScriptState : public ::testing::Test {
 protected:
  ScriptState() : L(luaL_newstate()) {
    luaL_openlibs(L);
    attach(L, session_);
  }
  ~ScriptState() override { close(); }

  void close() {
    if (L) lua_close(L);
    L = nullptr;
  }

  /// The results as text, separated by blanks, or "error: message".
  std::string run(const std::string& code) {
    lua_settop(L, 0);
    if (luaL_loadbuffer(L, code.data(), code.size(), "=test") || lua_pcall(L, 0, LUA_MULTRET, 0))
      return std::string("error: ") + luaL_tolstring(L, -1, nullptr);
    std::string text;
    for (int i = 1, count = lua_gettop(L); i <= count; ++i) {
      text += std::string(i > 1 ? " " : "") + luaL_tolstring(L, i, nullptr);
      lua_pop(L, 1);
    }
    return text;
  }

  Session session_;
  lua_State* L;
};

}  // namespace meander::script
