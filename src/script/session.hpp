// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "base/work.hpp"
#include "script/docs.hpp"

namespace meander::script {

/// Shared by everything that keeps a Lua value beyond a call: tells whether the state still lives, and which coroutine
/// runs now.
struct StateLife {
  lua_State* main = nullptr;     ///< null once the state is closed
  lua_State* running = nullptr;  ///< the coroutine of the innermost bound call
};

class Sandbox;

/// What one Lua state knows of the program around it. Must outlive the state.
struct Session {
  StopToken stop;  ///< set by Ctrl-C; long calls poll it
  std::function<void(double fraction, std::string_view label)> progress;
  std::function<void(std::string_view text)> write;  ///< where show() and help() write; empty: standard output
  bool at_prompt = false;
  bool terminal = false;  ///< pictures may use colours and escape codes
  Docs docs;
  std::shared_ptr<StateLife> life = std::make_shared<StateLife>();
  std::vector<const void*> in_use;   ///< objects that a call in progress must not find changed
  std::size_t native_debt = 0;       ///< bytes of native objects made since Lua's collector was last told
  std::shared_ptr<Sandbox> sandbox;  ///< null: the script may do what its user may
};

/// Ties the session to a fresh state: first call after luaL_newstate, before any coroutine is made.
void attach(lua_State* L, Session& session);
/// The session of a state or of one of its coroutines.
inline Session& session(lua_State* L) {
  Session* address = nullptr;
  std::memcpy(&address, lua_getextraspace(L), sizeof address);
  return *address;
}
/// Marks L as the running coroutine while it lives: callbacks into Lua run there.
class RunningScope {
 public:
  explicit RunningScope(lua_State* L) : life_(*session(L).life), before_(std::exchange(life_.running, L)) {}
  ~RunningScope() { life_.running = before_; }
  RunningScope(const RunningScope&) = delete;
  RunningScope& operator=(const RunningScope&) = delete;

 private:
  StateLife& life_;
  lua_State* before_;
};
/// Keeps other calls from changing an object while one is at work on it that may call back into Lua: they throw "the
/// sim is at work; ...".
class InUse {
 public:
  InUse(lua_State* L, const void* object, const char* name);
  ~InUse() { in_use_.pop_back(); }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;

 private:
  std::vector<const void*>& in_use_;
};
/// Stop token and progress for a long computation called from this state.
Work work_of(lua_State* L);
/// Takes the progress line away until the next report, because something else is about to be written.
void hide_progress(lua_State* L);
/// Writes to the session's output.
void write(lua_State* L, std::string_view text);

/// The error value of a stopped computation. The token stays set until the prompt is back, so that a script's pcall
/// cannot go on: its next long call, or the interpreter's hook, raises it again.
inline constexpr const char* kInterrupted = "interrupted";

}  // namespace meander::script
