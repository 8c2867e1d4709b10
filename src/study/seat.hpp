// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/hash.hpp"
#include "study/drive.hpp"
#include "study/metrics.hpp"

namespace meander {

/// One pilot in its seat: asks, commands, records.
class Seat {
 public:
  Seat(const Sim& sim, Pilot pilot, std::size_t robot);

  bool finished() const { return finished_; }
  double progress() const { return run_.subgoals > 0 ? static_cast<double>(run_.reached) / run_.subgoals : 0; }
  /// What is recorded so far: goals, subgoals reached and steps. The figures are written by result().
  const Run& run() const { return run_; }

  /// The command of this cycle; zero once the guide has finished.
  Command command(const Sim& sim);
  void record(const Sim& sim, const DriveOptions& options);
  void finish(const std::string& reason);
  /// Gives the run away.
  Run result(const Sim& sim);

 private:
  void ask(const Observation& observation);
  RunStep run_step(const Sim& sim, const RobotState& state) const;

  Pilot pilot_;
  std::size_t robot_;
  double start_time_;
  Metrics metrics_;
  Run run_;
  NavigatorStep last_;
  Hash hash_;
  double cpu_ = 0;
  int cycles_ = 0;
  bool trapped_ = false;  ///< in the last cycle
  bool finished_ = false;
};

}  // namespace meander
