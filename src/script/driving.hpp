// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <chrono>
#include <deque>

#include "script/control_options.hpp"
#include "script/kit_call.hpp"
#include "script/last_run.hpp"

namespace meander::script {

/// Everything that sim:drive takes.
struct DriveTable : PilotTable {
  std::optional<std::vector<PilotTable>> pilots;
  std::optional<Function> on_step;
  DriveOptions options;
};
template <class Options, class Visitor>
void drive_fields(Options& o, Visitor&& visit) {
  pilot_fields(o, visit);
  visit(Field{"pilots", "", "for several robots: one table each with navigator and subgoals or guide"}, o.pilots);
  visit(Field{"on_step", "", "function(sim) called after every cycle; it may edit the world; false ends the drive"},
        o.on_step);
  fields(o.options, visit);
}
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DriveTable>
void fields(Options& o, Visitor&& visit) { drive_fields(o, visit); }

/// A drive that a script ordered. However it ends (an interrupt, an error in a function of the script), the runs so far
/// are the simulation's last ones.
class Driving {
 public:
  Driving(const std::shared_ptr<Sim>& sim, const DriveTable& table, const Call& call);
  ~Driving();
  Driving(const Driving&) = delete;
  Driving& operator=(const Driving&) = delete;

  /// One cycle and on_step; false when the drive is over. Throws Cancelled when a stop was asked for.
  bool step();
  /// Tells the session's progress how far it is.
  void report();
  const Drive& state() const { return drive_; }
  /// Ends the drive and gives its runs.
  std::shared_ptr<DriveRuns> finish();

 private:
  void keep(const std::string& reason);
  std::string note() const;

  std::shared_ptr<Sim> sim_;
  Work work_;
  std::deque<InUse> in_use_;
  Drive drive_;
  OnStep on_step_;
  std::shared_ptr<DriveRuns> runs_;
  std::chrono::steady_clock::time_point begun_, reported_;
};

/// "2/3 subgoals", "2 subgoals" where nobody knows how many there will be; of all runs together.
std::string subgoals_text(const Drive& drive);

}  // namespace meander::script
