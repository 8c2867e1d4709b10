// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/test_jobs.hpp"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <map>
#include <optional>
#include <utility>

namespace meander {
namespace {

using Clock = std::chrono::steady_clock;

/// A stop, an end of time and a death without a word are seen within this time [ms].
constexpr int kPollTime = 20;
/// Between the request to stop and the kill [s].
constexpr double kGrace = 0.5;
constexpr std::size_t kOutputKept = 64 << 10;

class RunningJob {
 public:
  RunningJob(std::size_t index, const TestJob& job, const std::vector<int>& others)
      : index_(index),
        timeout_(job.timeout),
        started_(Clock::now()),
        process_(job.work, others, ChildProcess::Surroundings::own) {}

  std::size_t index() const { return index_; }
  const ChildProcess& process() const { return process_; }

  /// Looks after the process; its end, once.
  std::optional<TestJobEnd> check() {
    keep(process_.take_output());
    watch_time();
    auto result = process_.receive();
    if (!result) return std::nullopt;
    keep(process_.take_output());
    return TestJobEnd{std::move(*result), asked_, seconds(), std::move(output_)};
  }

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }

  void watch_time() {
    const double now = seconds();
    if (now > timeout_ && !asked_) {
      asked_ = true;
      process_.interrupt();
    }
    if (now > timeout_ + kGrace) process_.kill();
  }

  void keep(const std::string& written) {
    if (output_.size() <= kOutputKept) output_ += written;
    if (output_.size() <= kOutputKept) return;
    output_.resize(kOutputKept);
    output_ += "\n... and more\n";
  }

  std::size_t index_;
  double timeout_;
  Clock::time_point started_;
  bool asked_ = false;
  std::string output_;
  ChildProcess process_;
};

class JobPool {
 public:
  JobPool(const std::vector<TestJob>& jobs, std::size_t count) : jobs_(jobs), count_(std::max<std::size_t>(1, count)) {}

  bool complete() const { return next_ == jobs_.size() && running_.empty() && early_.empty(); }

  /// A machine that gives no more processes gets fewer jobs; one that gives none is an error.
  void employ() {
    while (running_.size() < count_ && next_ < jobs_.size()) {
      std::vector<int> others;
      for (const pollfd& open : descriptors()) others.push_back(open.fd);
      try {
        running_.emplace_back(next_, jobs_[next_], others);
      } catch (const Error&) {
        if (running_.empty()) throw;
        return;
      }
      ++next_;
    }
  }

  void listen() {
    std::vector<pollfd> open = descriptors();
    poll(open.data(), open.size(), kPollTime);
    for (auto job = running_.begin(); job != running_.end();) {
      auto end = job->check();
      if (end) early_.emplace(job->index(), std::move(*end));
      job = end ? running_.erase(job) : std::next(job);
    }
  }

  /// The ends whose turn it is. False when `take` has had enough.
  bool hand_over(const std::function<bool(std::size_t, const TestJobEnd&)>& take) {
    for (auto next = early_.find(taken_); next != early_.end(); next = early_.find(taken_)) {
      const TestJobEnd end = std::move(next->second);
      early_.erase(next);
      if (!take(taken_++, end)) return false;
    }
    return true;
  }

 private:
  std::vector<pollfd> descriptors() const {
    std::vector<pollfd> open;
    for (const RunningJob& job : running_)
      for (const int descriptor : {job.process().descriptor(), job.process().output_descriptor()})
        if (descriptor >= 0) open.push_back({descriptor, POLLIN, 0});
    return open;
  }

  const std::vector<TestJob>& jobs_;
  std::size_t count_;
  std::list<RunningJob> running_;
  std::map<std::size_t, TestJobEnd> early_;
  std::size_t next_ = 0;
  std::size_t taken_ = 0;
};

}  // namespace

bool run_test_jobs(const std::vector<TestJob>& jobs, std::size_t count, const StopToken& stop,
                   const std::function<bool(std::size_t, const TestJobEnd&)>& take) {
  JobPool pool(jobs, count);
  while (!pool.complete()) {
    if (stop.requested()) return false;
    pool.employ();
    pool.listen();
    if (!pool.hand_over(take)) return false;
  }
  return true;
}

}  // namespace meander
