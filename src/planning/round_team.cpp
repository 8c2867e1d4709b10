// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/round_team.hpp"

#include <algorithm>

namespace meander {

RoundTeam::RoundTeam(int helpers) {
  for (int i = 0; i < helpers; ++i) helpers_.emplace_back([this] { help(); });
}

RoundTeam::~RoundTeam() {
  over_ = true;
  for (std::thread& helper : helpers_) helper.join();
}

void RoundTeam::run(std::size_t count, std::size_t grain, const Job& job) {
  count_ = count, grain_ = grain, job_ = &job;
  next_ = 0;
  state_ += kRound + kOpen;
  work();
  state_ -= kOpen;  // nobody else comes in
  while (state_ % kRound != 0) std::this_thread::yield();
}

void RoundTeam::work() {
  for (;;) {
    const std::size_t from = next_.fetch_add(grain_);
    if (from >= count_) return;
    (*job_)(from, std::min(from + grain_, count_));
  }
}

void RoundTeam::help() {
  constexpr int kPatience = 200;
  std::uint64_t done = 0;
  for (int idle = 0; !over_; ++idle) {
    std::uint64_t state = state_;
    if (state % 2 == kOpen && state / kRound != done && state_.compare_exchange_strong(state, state + kHelper)) {
      done = state / kRound;
      work();
      state_ -= kHelper;
      idle = 0;
    } else if (idle > kPatience) {
      std::this_thread::yield();
    }
  }
}

}  // namespace meander
