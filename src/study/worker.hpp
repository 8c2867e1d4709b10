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

/// The parent's end of one worker process: a fork that runs trials by index, joined by a socket pair. Sockets and not
/// pipes, because send() can be told not to raise SIGPIPE.
class Worker {
 public:
  /// `others` are descriptors of this process that the child must not keep open.
  Worker(const std::function<std::string(std::size_t)>& trial, std::span<const int> others);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Kills the process if it still runs, and waits for it.
  ~Worker();

  int descriptor() const { return socket_; }
  bool idle() const { return !trial_; }
  void start(std::size_t trial);
  /// Reads what has come; a result when the trial is complete, or when the process has died over it.
  std::optional<TrialResult> receive();
  bool dead() const { return dead_; }

 private:
  TrialResult obituary();

  pid_t process_ = -1;
  int socket_ = -1;
  std::optional<std::size_t> trial_;
  std::string inbox_;
  bool dead_ = false;
};

}  // namespace meander
