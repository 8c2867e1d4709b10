// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/lua_interrupt.hpp"

#include <lauxlib.h>
#include <pthread.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <string_view>

#include "script/sandbox_state.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

// What the signal handler needs, and nothing else. Lock-free, written by the main thread only.
std::atomic<StopToken*> current_stop{nullptr};
std::atomic<lua_State*> main_state{nullptr};
std::atomic<lua_State*> running_state{nullptr};
std::atomic<const char*> farewell{nullptr};
pthread_t main_thread;
termios terminal_at_start;
bool terminal_known = false;
bool installed = false;

bool stopping() {
  const StopToken* stop = current_stop.load();
  return stop && stop->requested();
}

void raise_interrupt(lua_State* L, lua_Debug* activation) {
  if (!stopping()) return set_resting_hook(L);
  raise_stop(L, activation);
}

/// Counting single instructions is the only mask that is safe here: call and return hooks would also fire inside the
/// handler that builds the error message.
void hook(lua_State* L) {
  if (L) lua_sethook(L, raise_interrupt, LUA_MASKCOUNT, 1);
}

void write_now(int descriptor, std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(descriptor, text.data(), text.size());
}

void on_interrupt(int signal) {
  const int saved_errno = errno;
  if (!pthread_equal(pthread_self(), main_thread)) {
    pthread_kill(main_thread, signal);  // a Lua state may be hooked only by the thread that runs it
  } else if (StopToken* stop = current_stop.load()) {
    constexpr std::string_view kText = "\ninterrupted twice: left at once\n";  // behind the "^C" of a terminal
    if (stop->requested()) leave_at_once(kText.substr(terminal_known ? 0 : 1), 128 + SIGINT);
    stop_running();
  }
  errno = saved_errno;
}

void install() {
  main_thread = pthread_self();
  terminal_known = tcgetattr(STDIN_FILENO, &terminal_at_start) == 0;
  installed = true;
  struct sigaction action {};
  sigaction(SIGINT, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;  // started in the background: Ctrl-C is meant for others
  action = {};
  action.sa_handler = on_interrupt;  // without SA_RESTART: a read that blocks returns
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
}

}  // namespace

InterruptScope::InterruptScope(lua_State* main, StopToken& stop) : main_(main), stop_(stop) {
  if (!installed) install();
  stop_.clear();
  main_state = main;
  running_state = main;
  current_stop = &stop_;
}

InterruptScope::~InterruptScope() {
  current_stop = nullptr;
  running_state = nullptr;
  main_state = nullptr;
  set_resting_hook(main_);
  stop_.clear();
}

void release_interrupt_signal() {
  struct sigaction action {};
  sigaction(SIGINT, nullptr, &action);
  if (action.sa_handler == on_interrupt) std::signal(SIGINT, SIG_DFL);
  installed = false;
}

void set_farewell(const char* text) { farewell = text; }

void stop_running() {
  StopToken* stop = current_stop.load();
  if (!stop) return;
  stop->request();
  hook(main_state.load());
  hook(running_state.load());
}

bool script_runs() { return current_stop.load() != nullptr; }

void raise_stop(lua_State* L, lua_Debug* activation) {
  const std::string verdict = session(L).sandbox ? session(L).sandbox->verdict() : std::string();
  lua_getinfo(L, "Sl", activation);
  lua_pushfstring(L, "%s:%d: %s", activation->short_src, activation->currentline,
                  verdict.empty() ? kInterrupted : verdict.c_str());
  lua_error(L);
}

void leave_at_once(std::string_view last_words, int code) {
  if (const char* text = farewell.load()) write_now(STDOUT_FILENO, text);
  if (terminal_known) tcsetattr(STDIN_FILENO, TCSANOW, &terminal_at_start);
  write_now(STDERR_FILENO, last_words);
  _exit(code);
}

RunningThread::RunningThread(lua_State* thread, lua_State* from) : from_(from) {
  running_state = thread;
  if (stopping()) hook(thread);
}

RunningThread::~RunningThread() {
  running_state = from_;
  if (stopping()) hook(from_);
}

}  // namespace meander::script
