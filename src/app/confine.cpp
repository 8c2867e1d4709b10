// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/confine.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string_view>
#include <thread>

#include "script/sandbox_clock.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define MEANDER_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define MEANDER_ADDRESS_SANITIZER 1
#endif
#endif

#ifdef MEANDER_ADDRESS_SANITIZER
static bool confined = false;
/// The leak sanitizer asks this at the end: it reads /proc, which is closed then.
extern "C" int __lsan_is_turned_off() { return confined; }
#endif

namespace meander {
namespace {

#ifdef MEANDER_ADDRESS_SANITIZER
constexpr bool kLimitsMemory = false;  // its shadow memory is larger than any limit
#else
constexpr bool kLimitsMemory = true;
#endif

constexpr double kMebibyte = 1024 * 1024;

/// Never more than what was allowed before.
void limit(int resource, double most) {
  rlimit now{};
  if (getrlimit(static_cast<__rlimit_resource_t>(resource), &now) != 0) return;
  const rlim_t wanted = most < 1e18 ? static_cast<rlim_t>(most) : RLIM_INFINITY;
  now.rlim_max = std::min(now.rlim_max, wanted);
  now.rlim_cur = std::min(now.rlim_cur, now.rlim_max);
  setrlimit(static_cast<__rlimit_resource_t>(resource), &now);
}

/// Private memory of this process so far [bytes]: the sixth number of statm, in pages.
double memory_so_far() {
  unsigned long data = 0;
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (!file) return 0;
  if (std::fscanf(file, "%*u %*u %*u %*u %*u %lu", &data) != 1) data = 0;
  std::fclose(file);
  return static_cast<double>(data) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// The wall behind the counting of memory: what is asked for at once and not counted yet. Stacks of threads and the
/// room that an error message needs come on top.
void limit_memory(double mebibytes) {
  const double threads = std::max(1u, std::thread::hardware_concurrency());
  limit(RLIMIT_DATA, memory_so_far() + (mebibytes + 32 + 16 * threads) * kMebibyte);
}

/// The last resort where memory runs out in a place that cannot report it.
[[noreturn]] void give_up() {
  constexpr std::string_view kText = "meander: sandbox: ended by an error that could not be reported (memory?)\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kText.data(), kText.size());
  _exit(1);
}

}  // namespace

void confine(const script::SandboxOptions& options, const std::vector<std::string>& readable) {
#ifdef MEANDER_ADDRESS_SANITIZER
  confined = true;
#endif
  std::set_terminate(give_up);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of its writer
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_NOFILE, 256);
  limit(RLIMIT_FSIZE, options.output * kMebibyte);
  limit(RLIMIT_CPU, std::ceil(options.seconds) + 5);  // behind the clock, which tells why
  if (kLimitsMemory) limit_memory(options.memory);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);  // Landlock and seccomp ask for it
  confine_files(options.folder, readable);
  confine_calls();
  script::start_clock(options.seconds);
}

}  // namespace meander
