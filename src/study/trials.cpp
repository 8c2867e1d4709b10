// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/trials.hpp"

#include <poll.h>

#include <algorithm>
#include <exception>
#include <list>
#include <map>
#include <thread>
#include <vector>

#include "study/worker.hpp"

namespace meander {
namespace {

/// A stop is seen within this time [ms].
constexpr int kPollTime = 50;

/// Holds back what came too early.
class InOrder {
 public:
  InOrder(std::size_t count, const Work& work, const std::function<void(const TrialResult&)>& take)
      : count_(count), work_(work), take_(take) {}

  void add(TrialResult result) {
    early_.emplace(result.index, std::move(result));
    for (auto next = early_.find(done_); next != early_.end(); next = early_.find(done_)) {
      take_(next->second);
      early_.erase(next);
      ++done_;
      work_.report(static_cast<double>(done_) / static_cast<double>(count_), "trials");
    }
  }
  bool complete() const { return done_ == count_; }

 private:
  std::size_t count_;
  std::size_t done_ = 0;
  const Work& work_;
  const std::function<void(const TrialResult&)>& take_;
  std::map<std::size_t, TrialResult> early_;
};

TrialResult run_here(const std::function<std::string(std::size_t)>& trial, std::size_t index) {
  try {
    return {index, true, trial(index)};
  } catch (const std::exception& e) {
    return {index, false, e.what()};
  }
}

class Crew {
 public:
  Crew(std::size_t count, std::size_t jobs, const std::function<std::string(std::size_t)>& trial)
      : count_(count), jobs_(std::min(jobs, count)), trial_(trial) {}

  /// Everybody has something to do, as long as there is anything.
  void employ() {
    std::erase_if(workers_, [](const Worker& worker) { return worker.dead(); });
    while (workers_.size() < std::min(jobs_, workers_busy() + count_ - next_)) hire();
    for (Worker& worker : workers_)
      if (worker.idle() && next_ < count_) worker.start(next_++);
  }

  /// Waits a moment for results.
  template <class Take>
  void listen(Take take) {
    std::vector<pollfd> waiting;
    for (const Worker& worker : workers_) waiting.push_back({worker.descriptor(), POLLIN, 0});
    if (poll(waiting.data(), waiting.size(), kPollTime) <= 0) return;  // time is up, or a signal came
    auto ready = waiting.begin();
    for (Worker& worker : workers_)
      if ((ready++)->revents)
        if (auto result = worker.receive()) take(std::move(*result));
  }

 private:
  std::size_t workers_busy() const {
    return static_cast<std::size_t>(
        std::count_if(workers_.begin(), workers_.end(), [](const Worker& worker) { return !worker.idle(); }));
  }

  void hire() {
    std::vector<int> open;
    for (const Worker& worker : workers_) open.push_back(worker.descriptor());
    workers_.emplace_back(trial_, open);
  }

  std::size_t count_;
  std::size_t jobs_;
  const std::function<std::string(std::size_t)>& trial_;
  std::list<Worker> workers_;
  std::size_t next_ = 0;
};

}  // namespace

void run_trials(std::size_t count, int jobs, const Work& work, const std::function<std::string(std::size_t)>& trial,
                const std::function<void(const TrialResult&)>& take) {
  if (jobs < 0) fail("jobs: a number >= 0 expected, got {}", jobs);
  InOrder results(count, work, take);
  if (jobs == 1) {
    for (std::size_t i = 0; i < count; ++i) {
      work.poll();
      results.add(run_here(trial, i));
    }
    return;
  }
  const std::size_t workers =
      jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1u, std::thread::hardware_concurrency());
  Crew crew(count, workers, trial);
  while (!results.complete()) {
    work.poll();
    crew.employ();
    crew.listen([&](TrialResult result) { results.add(std::move(result)); });
  }
}

}  // namespace meander
