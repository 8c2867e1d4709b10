// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <string_view>

#include "base/work.hpp"

namespace meander::script {

/// While it lives, SIGINT stops what runs: the handler sets the stop token, which C++ loops poll, and hooks the Lua
/// state that runs. Hook and token stay until the scope ends, so that a pcall in the script cannot swallow the
/// interrupt. A second SIGINT before that restores the terminal and ends the process with 130. One scope at a time,
/// main thread only.
class InterruptScope {
 public:
  InterruptScope(lua_State* main, StopToken& stop);
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

 private:
  lua_State* main_;
  StopToken& stop_;
};

/// Between two scopes SIGINT does nothing, so that a late key press cannot end the program on the way to the prompt.
/// After this it ends the process again.
void release_interrupt_signal();

/// What the program writes to standard output when it is left at once, so that the terminal is usable; null for
/// nothing. The text must live on.
void set_farewell(const char* text);

/// Stops what runs now as the first SIGINT does. A signal handler of the main thread may call it.
void stop_running();
/// An InterruptScope lives.
bool script_runs();
/// Raises the error of a stop, as the hook does that a stop sets.
void raise_stop(lua_State* L, lua_Debug* activation);
/// Ends the process with the terminal restored. For signal handlers.
[[noreturn]] void leave_at_once(std::string_view last_words, int code);

/// Marks `thread` as the coroutine that runs until the end of the scope, resumed by `from`. Hooks are per coroutine in
/// Lua: an interrupt that is on its way is handed on to `thread` at the start and back to `from` at the end.
class RunningThread {
 public:
  RunningThread(lua_State* thread, lua_State* from);
  ~RunningThread();
  RunningThread(const RunningThread&) = delete;
  RunningThread& operator=(const RunningThread&) = delete;

 private:
  lua_State* from_;
};

}  // namespace meander::script
