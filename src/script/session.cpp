// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/session.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "script/sandbox_state.hpp"

namespace meander::script {
namespace {

/// Runs when the state is closed, after every object of the bindings: it was created first.
int on_close(lua_State* L) {
  session(L).life->main = nullptr;
  return 0;
}

}  // namespace

void attach(lua_State* L, Session& session) {
  Session* address = &session;
  static_assert(LUA_EXTRASPACE >= sizeof address);
  std::memcpy(lua_getextraspace(L), &address, sizeof address);
  session.life->main = session.life->running = L;
  static const char kSentinel = 0;
  lua_newuserdatauv(L, 0, 0);
  lua_createtable(L, 0, 1);
  lua_pushcfunction(L, on_close);
  lua_setfield(L, -2, "__gc");
  lua_setmetatable(L, -2);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &kSentinel);
}

InUse::InUse(lua_State* L, const void* object, const char* name) : in_use_(session(L).in_use) {
  if (std::find(in_use_.begin(), in_use_.end(), object) != in_use_.end())
    fail<Error>("the {} is at work; functions that it calls may look at it, but not drive it", name);
  in_use_.push_back(object);
}

Work work_of(lua_State* L) {
  Session& s = session(L);
  return {&s.stop, s.progress};
}

void hide_progress(lua_State* L) {
  if (const auto& progress = session(L).progress) progress(-1, "");
}

void write(lua_State* L, std::string_view text) {
  hide_progress(L);
  if (const auto& sandbox = session(L).sandbox) sandbox->charge_output(text.size());
  if (const auto& out = session(L).write)
    out(text);
  else
    std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace meander::script
