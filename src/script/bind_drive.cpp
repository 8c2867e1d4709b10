// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/driving.hpp"
#include "script/example_text.hpp"
#include "script/kit_type.hpp"

namespace meander::script {
namespace {

Pushed drive_from_lua(const std::shared_ptr<Sim>& sim, const DriveTable& table, const Call& call) {
  Driving driving(sim, table, call);
  while (driving.step()) driving.report();
  push_runs(call.L, *driving.finish());
  return {1};
}

Pushed last_run(const std::shared_ptr<Sim>& sim, const Call& call) {
  const auto runs = last_runs(call.L, sim);
  push_runs(call.L, runs ? *runs : DriveRuns{});
  return {1};
}

}  // namespace

void bind_drive(lua_State* L) {
  Type<Sim>(L)
      .method<&drive_from_lua>(Doc{.name = "drive",
                                   .text = "Closes the loop: guide, navigator, step, until the guide has finished, the "
                                           "time is up or on_step says so. What an interrupt or an error cuts short is "
                                           "kept: see last_run.",
                                   .args = {{"options", "who drives, and where to"}},
                                   .returns = "the run, or a list of runs where pilots were given",
                                   .returns_type = "run or list of run",
                                   .errors = "unknown navigator or place; errors of the functions given",
                                   .example = EXAMPLE_RUN "print(run)"})
      .method<&last_run>(
          Doc{.name = "last_run",
              .text = "The run of its last drive, also of one that was interrupted or ended in an error.",
              .returns = "the run as drive returns it, up to where it came; nil before the first drive and during one",
              .returns_type = "run or list of run",
              .example = EXAMPLE_RUN "print(s:last_run() == run)"});
}

}  // namespace meander::script
