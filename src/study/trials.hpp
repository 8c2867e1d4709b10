// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <functional>
#include <string>

#include "base/work.hpp"

namespace meander {

/// What became of one trial.
struct TrialResult {
  std::size_t index = 0;
  bool ok = false;
  std::string text;  ///< what the trial returned; when not ok: what went wrong, in words
};

/// Runs trial(0) .. trial(count - 1), each in a process of its own, forked from this one when its turn comes, and
/// `jobs` of them at a time (0: one per core). Nothing carries over from trial to trial, so the number of jobs changes
/// no result. Hands each result to `take` in this process, in the order of the index, whatever finishes first. A trial
/// that throws, exits or crashes is one result with ok = false; the others go on. A stop kills the workers and throws
/// Cancelled. A machine that gives fewer processes gets fewer jobs; Error when it gives none. A trial must not use
/// threads that were started before. `take` may throw: that ends the study.
void run_trials(std::size_t count, int jobs, const Work& work, const std::function<std::string(std::size_t)>& trial,
                const std::function<void(const TrialResult&)>& take);

}  // namespace meander
