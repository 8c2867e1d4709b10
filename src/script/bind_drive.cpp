// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/control_options.hpp"
#include "script/example_text.hpp"
#include "script/kit_type.hpp"

namespace meander::script {

struct DriveTable : PilotTable {
  std::vector<PilotTable> pilots;
  std::optional<Function> on_step;
  DriveOptions options;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, DriveTable>
void fields(Options& o, Visitor&& visit) {
  pilot_fields(o, visit);
  visit(Field{"pilots", "", "for several robots: one table each with navigator and subgoals or guide"}, o.pilots);
  visit(Field{"on_step", "", "function(sim) called after every cycle; it may edit the world; false ends the drive"},
        o.on_step);
  fields(o.options, visit);
}

namespace {

OnStep watcher(const std::shared_ptr<Sim>& sim, const std::optional<Function>& on_step) {
  if (!on_step) return {};
  return [sim, f = *on_step](const Sim&) {
    lua_State* L = f.invoke(1, sim);
    const bool go_on = !lua_isboolean(L, -1) || lua_toboolean(L, -1);
    lua_pop(L, 1);
    return go_on;
  };
}

std::vector<RunRecord> drive_all(const std::shared_ptr<Sim>& sim, const DriveTable& table, const Call& call) {
  std::vector<Pilot> pilots;
  const auto add = [&](const PilotTable& pilot) {
    if (pilots.size() == sim->robot_count())
      fail("option 'pilots': {} at most, one per robot, got {}", sim->robot_count(), table.pilots.size());
    pilots.push_back(pilot_of(pilot, sim->world(), sim->robot(pilots.size()).platform));
  };
  if (table.pilots.empty()) add(table);
  for (const PilotTable& pilot : table.pilots) add(pilot);
  const InUse in_use(call.L, sim.get(), "sim");
  std::vector<Run> runs = drive(*sim, pilots, table.options, call.work(), watcher(sim, table.on_step));
  const auto world = std::make_shared<const World>(sim->world());
  std::vector<RunRecord> records;
  for (Run& run : runs) records.push_back({std::move(run), world});
  return records;
}

Pushed drive_from_lua(const std::shared_ptr<Sim>& sim, const DriveTable& table, const Call& call) {
  std::vector<RunRecord> records = drive_all(sim, table, call);
  if (table.pilots.empty())
    push(call.L, records.front());
  else
    push(call.L, records);
  return {1};
}

}  // namespace

void bind_drive(lua_State* L) {
  Type<Sim>(L).method<&drive_from_lua>(Doc{
      .name = "drive",
      .text =
          "Closes the loop: guide, navigator, step, until the guide has finished, the time is up or on_step says so.",
      .args = {{"options", "who drives, and where to"}},
      .returns = "the run, or a list of runs where pilots were given",
      .errors = "unknown navigator or place; errors of the functions given",
      .example = EXAMPLE_RUN "print(run)"});
}

}  // namespace meander::script
