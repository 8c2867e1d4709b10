// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/terminal_device.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "render/screen.hpp"
#include "script/lua_interrupt.hpp"

namespace meander::script {
namespace {

constexpr std::array kSignals = {SIGTERM, SIGHUP, SIGQUIT, SIGTSTP};

// What the signal handler needs; written while none of its signals is handled.
std::array<struct sigaction, kSignals.size()> previous;
termios before;
bool echo_known = false;
volatile std::sig_atomic_t has_resumed = 0;

void set_echo(bool on) {
  if (!echo_known) return;
  termios mode = before;
  if (!on) mode.c_lflag &= ~static_cast<tcflag_t>(ECHO);
  tcsetattr(STDIN_FILENO, TCSANOW, &mode);
}

/// Puts the terminal back and does what the signal does by itself; after a stop it goes on with the picture.
void on_signal(int signal) {
  const int saved_errno = errno;
  [[maybe_unused]] const ssize_t written = ::write(STDOUT_FILENO, Screen::kLeave, std::strlen(Screen::kLeave));
  set_echo(true);
  struct sigaction standard {
  }, mine{};
  standard.sa_handler = SIG_DFL;
  sigemptyset(&standard.sa_mask);
  sigaction(signal, &standard, &mine);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  raise(signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);  // ends or stops here
  sigaction(signal, &mine, nullptr);
  set_echo(false);
  has_resumed = 1;
  errno = saved_errno;
}

}  // namespace

std::optional<TerminalSize> window_size() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return std::nullopt;
  return TerminalSize{std::min<int>(size.ws_col, 1000), std::min<int>(size.ws_row, 1000)};
}

std::size_t text_width() {
  constexpr TerminalSize kUnknown{80, 24};
  return isatty(STDOUT_FILENO) ? static_cast<std::size_t>(window_size().value_or(kUnknown).columns) : 0;
}

CellSize cell_size() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_xpixel < size.ws_col || size.ws_ypixel < size.ws_row ||
      size.ws_col == 0 || size.ws_row == 0)
    return {};
  return {size.ws_xpixel / size.ws_col, size.ws_ypixel / size.ws_row};
}

void write_at_once(std::string_view text) {
  std::fflush(stdout);
  while (!text.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
    if (count > 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN) {
      pollfd room{STDOUT_FILENO, POLLOUT, 0};
      poll(&room, 1, 100);
    } else if (errno != EINTR) {
      return;  // the terminal is gone
    }
  }
}

bool holds_terminal() { return isatty(STDOUT_FILENO) && tcgetpgrp(STDOUT_FILENO) == getpgrp(); }

LiveTerminal::LiveTerminal() {
  echo_known = isatty(STDIN_FILENO) && tcgetattr(STDIN_FILENO, &before) == 0;
  has_resumed = 0;
  set_echo(false);
  set_farewell(Screen::kLeave);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    struct sigaction action {};
    sigaction(kSignals[i], nullptr, &previous[i]);
    if (previous[i].sa_handler == SIG_IGN) continue;
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    sigaction(kSignals[i], &action, nullptr);
  }
}

LiveTerminal::~LiveTerminal() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &previous[i], nullptr);
  set_farewell(nullptr);
  set_echo(true);
}

bool LiveTerminal::resumed() {
  const bool was = has_resumed != 0;
  has_resumed = 0;
  return was;
}

}  // namespace meander::script
