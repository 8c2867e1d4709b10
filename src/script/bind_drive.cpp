// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <deque>
#include <set>

#include "script/bind.hpp"
#include "script/control_options.hpp"
#include "script/example_text.hpp"
#include "script/kit_type.hpp"

namespace meander::script {

struct DriveTable : PilotTable {
  std::optional<std::vector<PilotTable>> pilots;
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

/// The tables of all pilots: one of them or a list, not both.
std::vector<PilotTable> pilot_tables(const DriveTable& table, std::size_t robots) {
  if (!table.pilots) return {table};
  const char* also = table.navigator           ? "navigator"
                     : table.guide             ? "guide"
                     : !table.subgoals.empty() ? "subgoals"
                                               : nullptr;
  if (also) fail("options 'pilots' and '{}': one of them expected, got both", also);
  if (table.pilots->empty()) fail("option 'pilots': one table per robot expected, got {{}}");
  if (table.pilots->size() > robots)
    fail("option 'pilots': {} at most, one per robot, got {}", robots, table.pilots->size());
  return *table.pilots;
}

/// Keeps navigators and guides from being driven by somebody else meanwhile.
void mark_in_use(std::deque<InUse>& in_use, const std::vector<PilotTable>& tables, lua_State* L) {
  std::set<const void*> known;
  const auto mark = [&](const auto& option, const char* name) {
    if (!option || !option->object) return;
    if (!known.insert(option->object).second) fail("option 'pilots': each needs a {} of its own", name);
    in_use.emplace_back(L, option->object, name);
  };
  for (const PilotTable& table : tables) {
    mark(table.navigator, "navigator");
    mark(table.guide, "guide");
  }
}

std::vector<RunRecord> drive_all(const std::shared_ptr<Sim>& sim, const DriveTable& table, const Call& call) {
  const std::vector<PilotTable> tables = pilot_tables(table, sim->robot_count());
  std::vector<Pilot> pilots;
  for (const PilotTable& pilot : tables)
    pilots.push_back(pilot_of(pilot, sim->world(), sim->robot(pilots.size()).platform));
  std::deque<InUse> in_use;
  in_use.emplace_back(call.L, sim.get(), "sim");
  mark_in_use(in_use, tables, call.L);
  std::vector<Run> runs = drive(*sim, pilots, table.options, call.work(), watcher(sim, table.on_step));
  const auto world = std::make_shared<const World>(sim->world());
  std::vector<RunRecord> records;
  for (Run& run : runs) records.push_back({std::move(run), world});
  return records;
}

Pushed drive_from_lua(const std::shared_ptr<Sim>& sim, const DriveTable& table, const Call& call) {
  std::vector<RunRecord> records = drive_all(sim, table, call);
  if (table.pilots)
    push(call.L, records);
  else
    push(call.L, records.front());
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
