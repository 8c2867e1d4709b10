// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/pace.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace meander::script {
namespace {

std::chrono::steady_clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
}

double seconds(std::chrono::steady_clock::duration span) { return std::chrono::duration<double>(span).count(); }

}  // namespace

Pace::Pace(double speed, double rate, Work work)
    : speed_(std::isfinite(speed) ? speed : 0),
      interval_(duration_of(1 / rate)),
      work_(std::move(work)),
      begun_(Clock::now()),
      next_frame_(begun_),
      due_(begun_) {}

void Pace::pass(double from, double to, const std::function<void(double share)>& draw) {
  const Clock::duration span = duration_of(speed_ > 0 ? std::min((to - from) / speed_, 1e6) : 0);
  passed_ += to - from;
  due_ = speed_ > 0 ? due_ + span : Clock::now();
  while (next_frame_ <= due_) {
    wait_until(next_frame_);
    const Clock::time_point now = Clock::now();
    draw(span.count() > 0 ? std::clamp(1 - seconds(due_ - now) / seconds(span), 0.0, 1.0) : 1);
    next_frame_ = std::max(next_frame_ + interval_, now);
  }
  wait_until(due_);
  // Held up (stopped, or the machine is too slow): it goes on from here and does not hurry to catch up.
  due_ = std::max(due_, Clock::now() - 5 * interval_);
}

void Pace::wait_for_frame() {
  wait_until(next_frame_);
  next_frame_ = std::max(next_frame_ + interval_, Clock::now());
}

double Pace::measured() const { return passed_ / std::max(1e-6, seconds(Clock::now() - begun_)); }

void Pace::wait_until(Clock::time_point time) const {
  constexpr Clock::duration kSlice = std::chrono::milliseconds(20);
  for (;;) {
    work_.poll();
    const Clock::duration left = std::min(time - Clock::now(), kSlice);
    if (left <= Clock::duration::zero()) return;
    const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(left).count();
    const timespec span{.tv_sec = 0, .tv_nsec = static_cast<long>(nanoseconds)};
    nanosleep(&span, nullptr);  // a signal ends it early
  }
}

}  // namespace meander::script
