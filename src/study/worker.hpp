// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "base/child_process.hpp"
#include "study/trials.hpp"

namespace meander {

/// One trial in a process of its own.
class Worker {
 public:
  /// Starts trial(index); throws Error when there is no process to be had. `others` are descriptors of this process
  /// that the child must not keep open.
  Worker(const std::function<std::string(std::size_t)>& trial, std::size_t index, std::span<const int> others)
      : trial_(index), process_([&] { return trial(index); }, others) {}

  int descriptor() const { return process_.descriptor(); }
  /// Reads what has come; a result, the only one, when the trial is complete or the process has died over it.
  std::optional<TrialResult> receive() {
    auto result = process_.receive();
    if (!result) return std::nullopt;
    return TrialResult{trial_, result->ok, std::move(result->text)};
  }

 private:
  std::size_t trial_;
  ChildProcess process_;
};

}  // namespace meander
