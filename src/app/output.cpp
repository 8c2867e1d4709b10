// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "app/command_line.hpp"

namespace meander {
namespace {

void check_output() {
  errno = 0;
  const bool failed_before = std::ferror(stdout) != 0;
  if (std::fflush(stdout) == 0 && !failed_before) return;
  const int reason = errno;
  if (reason == EPIPE) _exit(128 + SIGPIPE);
  fmt::print(stderr, "meander: cannot write the results: {}\n", reason ? std::strerror(reason) : "write error");
  _exit(kExitScriptError);
}

}  // namespace

void check_output_at_exit() { std::atexit(check_output); }

void complain(const std::string& text) {
  std::fflush(stdout);
  fmt::print(stderr, "meander: {}\n", text);
}

}  // namespace meander
