// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <sys/types.h>

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace meander {

/// How the function of a ChildProcess ended.
struct ChildResult {
  bool ok = false;
  bool died = false;  ///< without a result: a crash, an exit, a kill
  std::string text;   ///< what it returned; when not ok: what went wrong, in words
};

/// The parent's end of a function that runs in a process of its own, forked from this one and joined by a socket pair.
/// A socket and not a pipe, because send() can be told not to raise SIGPIPE. The child ends with its parent.
class ChildProcess {
 public:
  enum class Surroundings {
    shared,  ///< the terminal's Ctrl-C is left to the parent; standard streams are the parent's
    own      ///< a process group of its own, no standard input, and its output comes here
  };

  /// Starts `work`; throws Error when there is no process to be had. `others` are descriptors of this process that the
  /// child must not keep open.
  ChildProcess(const std::function<std::string()>& work, std::span<const int> others,
               Surroundings surroundings = Surroundings::shared);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Kills the process, and those of its group, if they still run, and waits for it.
  ~ChildProcess();

  /// Readable when something has come; for poll().
  int descriptor() const { return socket_; }
  int output_descriptor() const { return output_; }

  /// Reads what has come; a result, the only one, when the work is complete or the process has died over it.
  std::optional<ChildResult> receive();
  /// Takes what was written to stdout and stderr since the last call.
  std::string take_output();
  /// Asks it to stop, as Ctrl-C does.
  void interrupt() const;
  /// Kills the process and, where it has surroundings of its own, those that it started.
  void kill();

 private:
  [[noreturn]] void live(int socket, int output, const std::function<std::string()>& work,
                         std::span<const int> others) noexcept;
  std::optional<ChildResult> complete_result() const;
  std::string end();

  Surroundings surroundings_;
  pid_t process_ = -1;
  int socket_ = -1;
  int output_ = -1;
  std::string inbox_;
};

}  // namespace meander
