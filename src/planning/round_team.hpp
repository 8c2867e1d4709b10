// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace meander {

/// Threads for rounds of work that last less than it takes to wake a thread up: helpers stay awake between rounds, and
/// no round waits for one that has not come. Helpers that find nothing to do leave the processor to others.
class RoundTeam {
 public:
  /// Does the items [from, to) of a round; must not throw.
  using Job = std::function<void(std::size_t from, std::size_t to)>;

  explicit RoundTeam(int helpers);
  ~RoundTeam();
  RoundTeam(const RoundTeam&) = delete;
  RoundTeam& operator=(const RoundTeam&) = delete;

  /// Does items 0 .. count - 1, `grain` at a time, on this thread and on the helpers that are there.
  void run(std::size_t count, std::size_t grain, const Job& job);

 private:
  static constexpr std::uint64_t kOpen = 1, kHelper = 2,
                                 kRound = 1u << 16;  ///< of state_: helpers inside, rounds so far

  void help();
  void work();

  std::atomic<std::uint64_t> state_{0};
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> over_{false};
  std::size_t count_ = 0, grain_ = 1;
  const Job* job_ = nullptr;
  std::vector<std::thread> helpers_;
};

}  // namespace meander
