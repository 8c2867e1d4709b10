// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/any.hpp"
#include "script/bind.hpp"
#include "script/example_text.hpp"
#include "script/kit_module.hpp"
#include "script/watch.hpp"

namespace meander::script {
namespace {

std::shared_ptr<DriveRuns> drive(const std::shared_ptr<Sim>& sim, const WatchTable& options, const Call& call) {
  try {
    return watch_drive(sim, options, call);
  } catch (const Cancelled&) {
    if (session(call.L).at_prompt) call.write("(sim:last_run() has the run so far)\n");
    throw;
  }
}

Pushed watch(const Any& what, const WatchTable& options, const Call& call) {
  if (test_box(call.L, what.index, tag_of<Sim>)) {
    const Path path{.kind = Path::Kind::value, .name = "sim"};
    push_runs(call.L, *drive(read_object<Sim>(call.L, what.index, path), options, call));
  } else if (test_box(call.L, what.index, tag_of<RunRecord>)) {
    const Path path{.kind = Path::Kind::value, .name = "run"};
    watch_run(*read_object<RunRecord>(call.L, what.index, path), options, call);
    lua_pushvalue(call.L, what.index);
  } else {
    fail("a sim (to drive it) or a run (to see it again) expected, got {}", describe(call.L, what.index));
  }
  return {1};
}

}  // namespace

void bind_watch(lua_State* L) {
  Module(L, "", "").function<&watch>(
      Doc{.name = "watch",
          .text = "Drives a sim as sim:drive does, or runs a run again, and shows it in the terminal meanwhile. "
                  "Ctrl-C ends it; sim:last_run() is the run so far.",
          .args = {{"object", "a sim or a run"},
                   {"options", "for a sim: who drives, and where to; for both: how fast it is shown"}},
          .returns = "the run, as sim:drive returns it",
          .returns_type = "run or list of run",
          .errors = "those of sim:drive; a run without recorded steps",
          .example = EXAMPLE_SIM "watch(s, { navigator = 'potential_field', subgoals = { {4, 2} } })"});
}

}  // namespace meander::script
