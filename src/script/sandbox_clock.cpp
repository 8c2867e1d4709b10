// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/sandbox_clock.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "script/lua_interrupt.hpp"

namespace meander::script {
namespace {

using Nanoseconds = std::int64_t;
constexpr Nanoseconds kSecond = 1'000'000'000;
constexpr Nanoseconds kGrace = kSecond;
constexpr long kTick = kSecond / 20;
constexpr int kSignal = SIGVTALRM;  ///< readline takes SIGALRM for itself

// All that the signal handler needs.
Nanoseconds computing_limit = 0;
Nanoseconds waiting_limit = 0;
std::atomic<Nanoseconds>* used = nullptr;  ///< computing time, shared with forks
Nanoseconds own_used = 0;                  ///< of it, by this process
Nanoseconds run_since = 0;                 ///< when the run that is in progress was first seen; 0: none
Nanoseconds over_since = 0;                ///< when the time was found used up; 0: it is not
std::atomic<const char*> verdict{nullptr};
std::string computing_text, waiting_text;
std::string last_words, last_words_in_call;
bool silent = false;
pthread_t main_thread;

Nanoseconds now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return time.tv_sec * kSecond + time.tv_nsec;
}

Nanoseconds of_ended_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto nanoseconds = [](const timeval& t) { return t.tv_sec * kSecond + t.tv_usec * 1000; };
  return nanoseconds(usage.ru_utime) + nanoseconds(usage.ru_stime);
}

/// Children too short-lived to be seen by a tick of their own are counted when they have ended.
bool computing_time_is_over() {
  const Nanoseconds own = now(CLOCK_PROCESS_CPUTIME_ID);
  const Nanoseconds all = *used += own - own_used;
  own_used = own;
  return std::max(all, own + of_ended_children()) >= computing_limit;
}

bool waits_too_long(Nanoseconds time) {
  if (!script_runs())
    run_since = 0;
  else if (run_since == 0)
    run_since = time;
  return run_since != 0 && time - run_since >= waiting_limit;
}

/// A view: the handler may have interrupted malloc, which a copy would need.
std::string_view farewell() {
  if (silent) return {};
  return script_runs() ? last_words_in_call : last_words;
}

void tick() {
  const Nanoseconds time = now(CLOCK_MONOTONIC);
  const bool computed = computing_time_is_over();
  if (!computed && !waits_too_long(time)) {
    over_since = 0;
    verdict = nullptr;
    return;
  }
  verdict = (computed ? computing_text : waiting_text).c_str();
  stop_running();
  if (over_since == 0) over_since = time;
  if (time - over_since >= kGrace) leave_at_once(farewell(), 1);
}

void on_tick(int signal) {
  const int saved_errno = errno;
  if (pthread_equal(pthread_self(), main_thread))
    tick();
  else
    pthread_kill(main_thread, signal);
  errno = saved_errno;
}

void set_timer() {
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = kSignal;
  timer_t timer{};
  if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0) fail<Error>("sandbox: no timer: {}", std::strerror(errno));
  const itimerspec period{{0, kTick}, {0, kTick}};
  timer_settime(timer, 0, &period, nullptr);
}

/// Timers do not pass to a fork, whose computing time starts at nothing.
void in_child() {
  own_used = 0;
  set_timer();
}

}  // namespace

void start_clock(double seconds) {
  void* page = mmap(nullptr, sizeof *used, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) throw std::bad_alloc();
  used = new (page) std::atomic<Nanoseconds>(0);
  computing_limit = static_cast<Nanoseconds>(seconds * kSecond);
  waiting_limit = 4 * computing_limit + 10 * kSecond;
  computing_text = fmt::format("sandbox: computing time of {} s used up", seconds);
  waiting_text = fmt::format("sandbox: time of {} s for one run used up", waiting_limit / kSecond);
  last_words = "meander: " + computing_text + "\n";
  last_words_in_call = "meander: " + computing_text + " in one call\n";
  main_thread = pthread_self();
  struct sigaction action {};
  action.sa_handler = on_tick;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(kSignal, &action, nullptr);
  pthread_atfork(nullptr, nullptr, in_child);
  set_timer();
}

const char* clock_verdict() { return verdict.load(); }

void silence_clock() { silent = true; }

}  // namespace meander::script
