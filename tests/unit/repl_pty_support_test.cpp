// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl_pty.hpp"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace meander::test {
namespace {

constexpr int kDeadline_ms = 10000;

void set_environment(const std::string& home, const std::map<std::string, std::string>& environment) {
  for (const char* name : {"XDG_STATE_HOME", "XDG_CONFIG_HOME", "NO_COLOR", "INPUTRC"}) unsetenv(name);
  setenv("HOME", home.c_str(), 1);
  setenv("TERM", "dumb", 1);
  setenv("LC_ALL", "C.UTF-8", 1);
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
  if (child_ > 0) return;
  set_environment(home, environment);
  if (chdir(home.c_str()) != 0) _exit(126);
  std::exit(main());
}

Terminal::~Terminal() {
  close(terminal_);
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

void Terminal::send(const std::string& keys) {
  if (write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
    throw std::runtime_error("cannot type into the terminal");
}

bool Terminal::read_some(int milliseconds) {
  pollfd wanted{terminal_, POLLIN, 0};
  if (closed_ || poll(&wanted, 1, milliseconds) <= 0) return false;
  char text[4096];
  const ssize_t length = read(terminal_, text, sizeof text);
  closed_ = length <= 0;  // the last process on the terminal is gone
  if (closed_) return false;
  transcript_.append(text, static_cast<std::size_t>(length));
  return true;
}

std::string Terminal::wait_for(const std::string& text) {
  for (;;) {
    const std::size_t found = transcript_.find(text, seen_);
    if (found != std::string::npos) {
      const std::string result = transcript_.substr(seen_, found + text.size() - seen_);
      seen_ = found + text.size();
      return result;
    }
    if (!read_some(kDeadline_ms)) throw std::runtime_error("'" + text + "' did not come:\n" + transcript_);
  }
}

std::string Terminal::enter(const std::string& line) {
  send(line + "\r");
  wait_for("\r\n");  // the echo of the line itself
  const std::size_t start = seen_;
  for (;;) {
    const std::size_t end = std::min(transcript_.find("\r\n> ", start - 2), transcript_.find("\r\n>> ", start - 2));
    if (end != std::string::npos) {
      const std::size_t prompt = end + 2;
      seen_ = transcript_.find(' ', prompt) + 1;
      const bool continues = transcript_[prompt + 1] == '>';
      return continues ? ">>" : transcript_.substr(start, prompt - start);
    }
    if (!read_some(kDeadline_ms)) throw std::runtime_error("no prompt came:\n" + transcript_);
  }
}

int Terminal::wait_for_exit() {
  while (read_some(kDeadline_ms)) continue;
  if (!closed_) throw std::runtime_error("the program did not end:\n" + transcript_);
  int status = 0;
  waitpid(child_, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int Terminal::interrupt_until_exit() {
  for (int tries = 0; tries < kDeadline_ms / 20 && !closed_; ++tries) {
    send("\x03");
    while (read_some(20)) continue;
  }
  return wait_for_exit();
}

bool Terminal::is_cooked() const {
  termios mode{};
  return tcgetattr(terminal_, &mode) == 0 && (mode.c_lflag & ICANON) && (mode.c_lflag & ECHO);
}

std::function<int()> program(std::vector<std::string> arguments) {
  return [arguments = std::move(arguments)]() mutable {
    std::string name = MEANDER_PROGRAM;
    std::vector<char*> pointers{name.data()};
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execv(name.c_str(), pointers.data());
    return 127;
  };
}

}  // namespace meander::test
