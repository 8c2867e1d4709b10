// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "base/work.hpp"
#include "robot/contracts.hpp"
#include "sim/sim.hpp"
#include "study/run.hpp"

namespace meander {

struct DriveOptions {
  double time_limit = 600;       ///< [s] of simulated time
  bool stop_on_contact = false;  ///< end the drive at the first contact of a driven robot
  int record_every = 1;          ///< keep every n-th cycle as a RunStep; 0: none
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DriveOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"time_limit", "s", "simulated time after which the drive ends", 0, 1e9}, o.time_limit);
  visit(Field{"stop_on_contact", "", "end at the first contact"}, o.stop_on_contact);
  visit(Field{"record_every", "", "keep every n-th cycle; 0: none", 0, 1e9}, o.record_every);
}

/// Called after every cycle; may edit the world (sim.shared_world()); returns false to end the drive.
using OnStep = std::function<bool(const Sim&)>;

/// Who drives a robot, and where to.
struct Pilot {
  Navigator navigator;
  Guide guide;
};

class Seat;

/// A loop that is being closed, cycle by cycle, from the simulation's present state on: guide, navigator, step. Robot k
/// is driven by pilot k; robots without a pilot, or whose guide has finished, stand still. Both contracts are reset
/// first.
class Drive {
 public:
  /// Throws ArgumentError for more pilots than robots, and for navigators made for robots of another size.
  Drive(Sim& sim, std::span<const Pilot> pilots, const DriveOptions& options = {});
  ~Drive();
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  /// One cycle. False, without one, when every guide has finished or the time is up.
  bool step();
  /// Ends it for all pilots that have not finished.
  void stop(const std::string& reason);
  bool finished() const;

  double time() const;      ///< since its begin [s]
  double progress() const;  ///< share of the subgoals or of the time, whichever is larger, in [0, 1]
  std::size_t pilots() const;
  /// What is recorded so far: goals, subgoals reached, steps.
  const Run& run(std::size_t pilot) const;
  /// One run per pilot, whether it has finished or not. Gives them away: the drive is over then.
  std::vector<Run> results();

 private:
  Sim& sim_;
  DriveOptions options_;
  double start_;
  std::vector<Seat> seats_;
  std::vector<Command> commands_;
};

/// A whole drive, until the guides have finished, the time is up or `on_step` says so. Returns one run per pilot.
/// Throws Cancelled when a stop was asked for.
std::vector<Run> drive(Sim& sim, std::span<const Pilot> pilots, const DriveOptions& options = {}, const Work& work = {},
                       const OnStep& on_step = {});

/// The same for robot 0 alone.
Run drive(Sim& sim, const Navigator& navigator, const Guide& guide, const DriveOptions& options = {},
          const Work& work = {}, const OnStep& on_step = {});

}  // namespace meander
