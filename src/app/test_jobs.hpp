// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/child_process.hpp"
#include "base/work.hpp"

namespace meander {

/// Something that runs in a process of its own and must end in time.
struct TestJob {
  std::function<std::string()> work;
  double timeout = 60;  ///< [s] of the clock on the wall: a process may also hang without computing
};

struct TestJobEnd {
  ChildResult result;
  bool timed_out = false;
  double seconds = 0;
  std::string output;  ///< what it wrote to stdout and stderr, the first 64 KiB
};

/// Runs `count` jobs at a time, in the order of the list, and hands their ends to `take` in that order, whatever
/// finishes first. A job whose time is up is asked to stop, as by Ctrl-C, so that it can say where it was; half a
/// second later it is killed. Ends early when `stop` is requested or `take` returns false; no process is left then.
/// True when all were taken.
bool run_test_jobs(const std::vector<TestJob>& jobs, std::size_t count, const StopToken& stop,
                   const std::function<bool(std::size_t, const TestJobEnd&)>& take);

}  // namespace meander
