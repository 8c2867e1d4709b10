// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/trials.hpp"

#include <poll.h>

#include <algorithm>
#include <iterator>
#include <list>
#include <map>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "study/worker.hpp"

namespace meander {
namespace {

/// A stop is seen within this time [ms].
constexpr int kPollTime = 50;
/// So many attempts to get a process fail before the study does: 5 s when none is at work.
constexpr int kPatience = 100;

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

class Crew {
 public:
  Crew(std::size_t count, std::size_t jobs, const std::function<std::string(std::size_t)>& trial)
      : count_(count), jobs_(std::min(jobs, count)), trial_(trial) {}

  /// As many trials at work as there are jobs. A machine that gives no more processes gets fewer jobs.
  void employ() {
    try {
      while (workers_.size() < jobs_ && next_ < count_) hire();
    } catch (const Error&) {
      if (next_ == 0 || ++refused_ > kPatience) throw;
      jobs_ = std::max<std::size_t>(1, workers_.size());
    }
  }

  /// Waits a moment for results.
  template <class Take>
  void listen(Take take) {
    std::vector<pollfd> waiting;
    for (const Worker& worker : workers_) waiting.push_back({worker.descriptor(), POLLIN, 0});
    if (poll(waiting.data(), waiting.size(), kPollTime) <= 0) return;  // time is up, or a signal came
    auto ready = waiting.begin();
    for (auto worker = workers_.begin(); worker != workers_.end();) {
      auto result = (ready++)->revents ? worker->receive() : std::nullopt;
      worker = result ? workers_.erase(worker) : std::next(worker);
      if (result) take(std::move(*result));
    }
  }

 private:
  void hire() {
    std::vector<int> open;
    for (const Worker& worker : workers_) open.push_back(worker.descriptor());
    workers_.emplace_back(trial_, next_, open);
    ++next_;
    refused_ = 0;
  }

  std::size_t count_;
  std::size_t jobs_;
  const std::function<std::string(std::size_t)>& trial_;
  std::list<Worker> workers_;
  std::size_t next_ = 0;
  int refused_ = 0;  ///< attempts in a row to get a process
};

}  // namespace

void run_trials(std::size_t count, int jobs, const Work& work, const std::function<std::string(std::size_t)>& trial,
                const std::function<void(const TrialResult&)>& take) {
  if (jobs < 0) fail("jobs: a number >= 0 expected, got {}", jobs);
  InOrder results(count, work, take);
  const std::size_t workers =
      jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1u, std::thread::hardware_concurrency());
  Crew crew(count, workers, trial);
  while (!results.complete()) {
    work.poll();
    crew.employ();
    crew.listen([&](TrialResult result) { results.add(std::move(result)); });
  }
  work.poll();  // what a trial says that was forked after the stop counts for nothing
}

}  // namespace meander
