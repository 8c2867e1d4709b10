// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/driving.hpp"

#include <new>
#include <set>

#include "autonomy/sonar_explorer.hpp"

namespace meander::script {
namespace {

using Clock = std::chrono::steady_clock;

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

std::vector<Pilot> pilots_of(const std::vector<PilotTable>& tables, const Sim& sim) {
  std::vector<Pilot> pilots;
  for (const PilotTable& pilot : tables)
    pilots.push_back(pilot_of(pilot, sim.world(), sim.robot(pilots.size()).platform));
  return pilots;
}

/// Keeps the simulation, navigators and guides from being driven by somebody else meanwhile.
std::deque<InUse> seized(const Sim& sim, const std::vector<PilotTable>& tables, lua_State* L) {
  std::deque<InUse> in_use;
  in_use.emplace_back(L, &sim, "sim");
  std::set<const void*> known;
  const auto mark = [&](const auto& option, const char* name) {
    if (!option || !option->object) return;
    if (!known.insert(option->object).second) fail("option 'pilots': each needs a {} of its own", name);
    in_use.emplace_back(L, option->object, name);
  };
  for (const PilotTable& table : tables) {
    mark(table.navigator, "navigator");
    mark(table.guide, "guide");
    if (!table.guide || !table.guide->object) continue;
    const auto explorer = explorer_of(*static_cast<const Guide*>(table.guide->object));
    if (explorer) in_use.emplace_back(L, explorer.get(), "explorer");  // it gives as many guides as are asked for
  }
  return in_use;
}

}  // namespace

std::string subgoals_text(const Drive& drive) {
  int reached = 0, all = 0;
  for (std::size_t k = 0; k < drive.pilots(); ++k) {
    reached += drive.run(k).reached;
    all += drive.run(k).subgoals;
  }
  return all > 0 ? fmt::format("{}/{} subgoals", reached, all) : fmt::format("{} subgoals", reached);
}

Driving::Driving(const std::shared_ptr<Sim>& sim, const DriveTable& table, const Call& call)
    : sim_(sim),
      work_(call.work()),
      in_use_(seized(*sim, pilot_tables(table, sim->robot_count()), call.L)),
      drive_(*sim, pilots_of(pilot_tables(table, sim->robot_count()), *sim), table.options),
      on_step_(watcher(sim, table.on_step)),
      runs_(std::make_shared<DriveRuns>()),
      begun_(Clock::now()) {
  runs_->listed = table.pilots.has_value();
  remember_runs(call.L, sim, runs_);
}

Driving::~Driving() {
  try {
    if (runs_->runs.empty()) keep(work_.stop && work_.stop->requested() ? "interrupted" : "stopped by an error");
  } catch (const std::bad_alloc&) {
    // the error that is on its way matters more than the runs
  }
}

bool Driving::step() {
  work_.poll();
  if (!drive_.step()) return false;
  if (on_step_ && !on_step_(*sim_)) drive_.stop("stopped by on_step");
  return true;
}

void Driving::report() {
  constexpr std::chrono::milliseconds kBetween{50};
  const Clock::time_point now = Clock::now();
  if (!work_.progress || now - reported_ < kBetween) return;
  reported_ = now;
  work_.report(drive_.progress(), note());
}

std::shared_ptr<DriveRuns> Driving::finish() {
  if (runs_->runs.empty()) keep("interrupted");
  return runs_;
}

/// Runs that have ended by themselves keep their own reason.
void Driving::keep(const std::string& reason) {
  drive_.stop(reason);
  const auto world = std::make_shared<const World>(sim_->world());
  std::vector<std::shared_ptr<RunRecord>> records;
  for (Run& run : drive_.results()) records.push_back(std::make_shared<RunRecord>(RunRecord{std::move(run), world}));
  runs_->runs = std::move(records);
}

/// "driving<tab>2/3 subgoals  41.2 s  (3100x)"
std::string Driving::note() const {
  const double elapsed = std::chrono::duration<double>(Clock::now() - begun_).count();
  return fmt::format("driving\t{}  {:.1f} s  ({:.0f}x)", subgoals_text(drive_), drive_.time(), drive_.time() / elapsed);
}

}  // namespace meander::script
