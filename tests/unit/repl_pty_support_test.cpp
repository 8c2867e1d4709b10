// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl_pty.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace meander::test {
namespace {

constexpr int kDeadline_ms = 10000;

void set_environment(const std::string& home, const std::map<std::string, std::string>& environment) {
  for (const char* name : {"XDG_STATE_HOME", "XDG_CONFIG_HOME", "NO_COLOR", "INPUTRC", "VISUAL", "EDITOR", "COLORTERM"})
    unsetenv(name);
  setenv("HOME", home.c_str(), 1);
  setenv("TERM", "dumb", 1);
  setenv("LC_ALL", "C.UTF-8", 1);
  setenv("MEANDER", MEANDER_PROGRAM, 1);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  std::signal(SIGINT, SIG_DFL);  // ignored where the tests run in the background
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  path_ = (std::filesystem::temp_directory_path() / "meander-test-XXXXXX").string();
  if (!mkdtemp(path_.data())) throw std::runtime_error("no temporary folder");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Terminal::Terminal(const std::string& home, const std::function<int()>& main,
                   const std::map<std::string, std::string>& environment) {
  winsize size{.ws_row = 40, .ws_col = 160, .ws_xpixel = 0, .ws_ypixel = 0};
  child_ = forkpty(&terminal_, nullptr, nullptr, &size);
  if (child_ < 0) throw std::runtime_error("no pseudo-terminal");
  if (child_ > 0) {
    fcntl(terminal_, F_SETFL, O_NONBLOCK);
    return;
  }
  set_environment(home, environment);
  if (chdir(home.c_str()) != 0) _exit(126);
  std::exit(main());
}

Terminal::~Terminal() {
  close(terminal_);
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

void Terminal::send(const std::string& keys) {
  for (std::size_t sent = 0; sent < keys.size();) {
    pollfd room{terminal_, POLLOUT, 0};
    const ssize_t written = poll(&room, 1, 10) > 0 ? write(terminal_, keys.data() + sent, keys.size() - sent) : 0;
    if (written < 0 && errno != EAGAIN) throw std::runtime_error("cannot type into the terminal");
    if (written > 0) sent += static_cast<std::size_t>(written);
    while (read_some(0)) continue;  // or its output could keep the program from reading
  }
}

bool Terminal::read_some(int milliseconds) {
  pollfd wanted{terminal_, POLLIN, 0};
  if (closed_ || poll(&wanted, 1, milliseconds) <= 0) return false;
  char text[4096];
  const ssize_t length = read(terminal_, text, sizeof text);
  closed_ = length <= 0;  // the last process on the terminal is gone
  if (closed_) return false;
  raw_.append(text, static_cast<std::size_t>(length));
  add_plain();
  return true;
}

void Terminal::add_plain() {
  constexpr std::string_view kFinal = "@ABCDEFGHIJKLMNOPQRSTUVWXYZ`abcdefghijklmnopqrstuvwxyz";
  constexpr std::string_view kEndsPaste = "\x1b[?2004l\r";  // readline writes both before a line's output
  while (plain_to_ < raw_.size()) {
    if (raw_[plain_to_] != '\x1b') {
      const char c = raw_[plain_to_++];
      if (c != '\a') text_ += c;
      continue;
    }
    if (plain_to_ + 1 == raw_.size()) return;  // the rest of it has not come yet
    const std::size_t end = raw_[plain_to_ + 1] == '[' ? raw_.find_first_of(kFinal, plain_to_ + 2) : plain_to_ + 1;
    if (end == std::string::npos) return;
    const bool paste = raw_.compare(plain_to_, kEndsPaste.size() - 1, kEndsPaste, 0, kEndsPaste.size() - 1) == 0;
    if (paste && end + 1 == raw_.size()) return;
    plain_to_ = end + 1 + (paste && raw_[end + 1] == '\r');
  }
}

std::string Terminal::wait_for(const std::string& text) {
  for (;;) {
    const std::size_t found = text_.find(text, seen_);
    if (found != std::string::npos) {
      const std::string result = text_.substr(seen_, found + text.size() - seen_);
      seen_ = found + text.size();
      return result;
    }
    if (!read_some(kDeadline_ms)) throw std::runtime_error("'" + text + "' did not come:\n" + text_);
  }
}

std::string Terminal::enter(const std::string& line) {
  send(line + "\r");
  wait_for("\r\n");  // the echo of the line itself
  const std::size_t start = seen_;
  for (;;) {
    const std::size_t end = std::min(text_.find("\r\n> ", start - 2), text_.find("\r\n>> ", start - 2));
    if (end != std::string::npos) {
      const std::size_t prompt = end + 2;
      seen_ = text_.find(' ', prompt) + 1;
      const bool continues = text_[prompt + 1] == '>';
      return continues ? ">>" : text_.substr(start, prompt - start);
    }
    if (!read_some(kDeadline_ms)) throw std::runtime_error("no prompt came:\n" + text_);
  }
}

int Terminal::wait_for_exit() {
  while (read_some(kDeadline_ms)) continue;
  if (!closed_) throw std::runtime_error("the program did not end:\n" + text_);
  return reap();
}

int Terminal::reap() {
  int status = 0;
  waitpid(child_, &status, 0);
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int Terminal::wait_for_death() {
  for (int tries = 0; tries < kDeadline_ms / 10; ++tries) {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == child_)
      return reap();
    poll(nullptr, 0, 10);
  }
  throw std::runtime_error("the program lives on:\n" + text_);
}

void Terminal::hang_up() {
  close(terminal_);
  terminal_ = -1;
  closed_ = true;
}

void Terminal::resize(int rows, int columns) {
  const winsize size{.ws_row = static_cast<unsigned short>(rows),
                     .ws_col = static_cast<unsigned short>(columns),
                     .ws_xpixel = 0,
                     .ws_ypixel = 0};
  ioctl(terminal_, TIOCSWINSZ, &size);
}

int Terminal::interrupt_until_exit() {
  for (int tries = 0; tries < kDeadline_ms / 20 && !closed_; ++tries) {
    send("\x03");
    while (read_some(20)) continue;
  }
  return wait_for_exit();
}

std::string Terminal::wait_for_raw(const std::string& text) {
  for (;;) {
    const std::size_t found = raw_.find(text, raw_seen_);
    if (found != std::string::npos) {
      const std::string result = raw_.substr(raw_seen_, found + text.size() - raw_seen_);
      raw_seen_ = found + text.size();
      return result;
    }
    if (!read_some(kDeadline_ms)) throw std::runtime_error("'" + text + "' did not come:\n" + raw_);
  }
}

void Terminal::kill_with(int signal) { kill(child_, signal); }

bool Terminal::is_cooked() const {
  termios mode{};
  return tcgetattr(terminal_, &mode) == 0 && (mode.c_lflag & ICANON) && (mode.c_lflag & ECHO);
}

std::function<int()> other_program(std::vector<std::string> arguments) {
  return [arguments = std::move(arguments)]() mutable {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execvp(pointers[0], pointers.data());
    return 127;
  };
}

std::function<int()> program(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), MEANDER_PROGRAM);
  return other_program(std::move(arguments));
}

std::function<int()> shell(std::string command) { return other_program({"sh", "-c", std::move(command)}); }

}  // namespace meander::test
