// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "app/command_line.hpp"
#include "base/visible_text.hpp"

namespace meander {
namespace {

/// Why the stream failed is forgotten by then; writing once more tells.
int reason_of_failure() {
  std::clearerr(stdout);
  errno = 0;
  return std::fputc('\n', stdout) == EOF || std::fflush(stdout) != 0 ? errno : 0;
}

void check_output() {
  const bool failed_before = std::ferror(stdout) != 0;
  errno = 0;
  if (std::fflush(stdout) == 0 && !failed_before) return;
  const int reason = errno ? errno : reason_of_failure();
  if (reason == EPIPE) _exit(128 + SIGPIPE);
  fmt::print(stderr, "meander: cannot write all results: {}\n", reason ? std::strerror(reason) : "write error");
  _exit(kExitScriptError);
}

/// A descriptor that is closed at the start would be given to the first file that is opened, and results would go
/// there.
void keep_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0) open("/dev/null", O_RDWR);
}

}  // namespace

void guard_output() {
  keep_standard_descriptors();
  std::atexit(check_output);
}

void complain(const std::string& text) {
  std::fflush(stdout);
  fmt::print(stderr, "meander: {}\n", visible_text(text));
}

bool is_able_terminal(int descriptor) {
  const char* term = std::getenv("TERM");
  return isatty(descriptor) && term && *term && std::string_view(term) != "dumb";
}

}  // namespace meander
