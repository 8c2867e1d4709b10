// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>
#include <vector>

#include "script/objects.hpp"

namespace meander::script {

/// The runs of one drive, as Lua gets them.
struct DriveRuns {
  std::vector<std::shared_ptr<RunRecord>> runs;  ///< empty while the drive goes on
  bool listed = false;                           ///< pilots were given: a list, however short
};
template <>
struct ObjectName<DriveRuns> {
  static constexpr const char* value = "runs of a drive";
};

/// Ties the runs to their simulation as its last ones, for as long as Lua holds it. They may be filled in later.
void remember_runs(lua_State* L, const std::shared_ptr<Sim>& sim, const std::shared_ptr<DriveRuns>& runs);
/// The runs last tied to the simulation; null where there are none.
std::shared_ptr<DriveRuns> last_runs(lua_State* L, const std::shared_ptr<Sim>& sim);
/// Pushes the run, or the list of them; nil while there are none.
void push_runs(lua_State* L, const DriveRuns& runs);

}  // namespace meander::script
