// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "study/trials.hpp"

namespace meander {

/// The parent's end of one worker process: a fork that runs one trial, joined by a socket pair. A socket and not a
/// pipe, because send() can be told not to raise SIGPIPE.
class Worker {
 public:
  /// Starts trial(index); throws Error when there is no process to be had. `others` are descriptors of this process
  /// that the child must not keep open.
  Worker(const std::function<std::string(std::size_t)>& trial, std::size_t index, std::span<const int> others);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Kills the process if it still runs, and waits for it.
  ~Worker();

  int descriptor() const { return socket_; }
  /// Reads what has come; a result, the only one, when the trial is complete or the process has died over it.
  std::optional<TrialResult> receive();

 private:
  pid_t process_ = -1;
  int socket_ = -1;
  std::size_t trial_;
  std::string inbox_;
};

}  // namespace meander
