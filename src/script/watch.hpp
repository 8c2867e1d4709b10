// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/driving.hpp"

namespace meander::script {

/// Simulated seconds per second; 0 and math.huge: as fast as it goes.
struct Speed {
  double value = 1;
};
template <>
struct Lua<Speed> {
  static Speed read(lua_State* L, int index, const Path& path);
  static std::string type() { return "number"; }
};

/// What watch takes: the options of a drive, and how to look at it.
struct WatchTable : DriveTable {
  std::optional<Speed> speed;
  double rate = 20;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WatchTable>
void fields(Options& o, Visitor&& visit) {
  drive_fields(o, visit);
  visit(Field{"speed", "", "simulated seconds per second, 1 when left out; 0 or math.huge: as fast as it goes"},
        o.speed);
  visit(Field{"rate", "1/s", "pictures per second, at most", 0.1, 100}, o.rate);
}

/// Drives as sim:drive does and shows it while it goes on, where there is a terminal; the last picture stays.
std::shared_ptr<DriveRuns> watch_drive(const std::shared_ptr<Sim>& sim, const WatchTable& table, const Call& call);
/// Shows a recorded run again.
void watch_run(const RunRecord& record, const WatchTable& table, const Call& call);

}  // namespace meander::script
