// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <atomic>
#include <functional>
#include <string_view>

#include "base/error.hpp"

namespace meander {

/// Asked by long loops; set from a signal handler or another thread.
class StopToken {
 public:
  void request() { flag_.store(true, std::memory_order_relaxed); }
  void clear() { flag_.store(false, std::memory_order_relaxed); }
  bool requested() const { return flag_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> flag_{false};
};

/// What a long computation is given: may it go on, and who wants to hear how far it is. Every loop that can exceed
/// 50 ms calls poll() about every millisecond of work. The default neither stops nor reports.
struct Work {
  const StopToken* stop = nullptr;
  /// fraction in [0, 1] and a short label; called from the thread that runs the loop.
  std::function<void(double fraction, std::string_view label)> progress;

  /// Throws Cancelled when a stop was asked for.
  void poll() const {
    if (stop && stop->requested()) throw Cancelled{};
  }
  void report(double fraction, std::string_view label) const {
    if (progress) progress(fraction, label);
  }
};

}  // namespace meander
