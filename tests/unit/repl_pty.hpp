// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <sys/types.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace meander::test {

/// A folder of its own for one test, gone at its end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

/// A program on a pseudo-terminal. Waits for texts, never for a time; whatever does not come within ten seconds throws.
/// Escape sequences and bells are left out of the texts, so that they read alike on every kind of terminal.
class Terminal {
 public:
  /// `main` becomes the whole child process, in `home`, with TERM=dumb unless `environment` says otherwise.
  Terminal(const std::string& home, const std::function<int()>& main,
           const std::map<std::string, std::string>& environment = {});
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void send(const std::string& keys);
  /// What came since the last wait, up to and with `text`.
  std::string wait_for(const std::string& text);
  /// Sends a line and waits for the next prompt: what came in between, or ">>" where more lines are wanted.
  std::string enter(const std::string& line);
  /// Reads to the end: the exit code.
  int wait_for_exit();
  /// Waits until the program is gone, whoever else may still use the terminal.
  int wait_for_death();
  /// Hangs up, as a terminal window does that is closed.
  void hang_up();
  void resize(int rows, int columns);
  /// Presses Ctrl-C again and again until the program ends: the exit code.
  int interrupt_until_exit();
  /// The same in what came since the last wait of this kind, escape sequences included.
  std::string wait_for_raw(const std::string& text);
  void kill_with(int signal);
  /// Line editing and echo are left to the terminal, as before the program ran.
  bool is_cooked() const;
  /// Everything since the start, without escape sequences and as it came.
  const std::string& transcript() const { return text_; }
  const std::string& raw_transcript() const { return raw_; }

 private:
  bool read_some(int milliseconds);
  void add_plain();
  int reap();

  int terminal_ = -1;
  pid_t child_ = -1;
  std::string raw_;
  std::string text_;  ///< raw_ up to plain_to_, without escape sequences
  std::size_t plain_to_ = 0;
  std::size_t seen_ = 0;
  std::size_t raw_seen_ = 0;
  bool closed_ = false;
};

/// The built program with these arguments.
std::function<int()> program(std::vector<std::string> arguments = {});
/// A command of the shell, in which $MEANDER is the built program.
std::function<int()> shell(std::string command);
/// Another program, looked up on PATH.
std::function<int()> other_program(std::vector<std::string> arguments);

}  // namespace meander::test
