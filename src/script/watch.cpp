// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/watch.hpp"

#include <cmath>

#include "autonomy/sonar_explorer.hpp"
#include "render/draw_indicators.hpp"
#include "script/live_view.hpp"
#include "script/picture.hpp"

namespace meander::script {
namespace {

double speed_of(const WatchTable& table) { return table.speed.value_or(Speed{}).value; }

TrackGoal goal_of(const Subgoal& subgoal, bool reached) { return {subgoal.position, subgoal.tolerance, reached}; }

/// What follows the time in the line below a live picture.
std::string state_text(double v, double clearance, bool touching) {
  return fmt::format("{:.2f} m/s  {}", v, touching ? "contact" : fmt::format("clearance {:.2f} m", clearance));
}

/// A narrow window cuts the end: how to get out comes first.
std::string line_text(double time, double speed, const std::string& subgoals, const std::string& state) {
  return fmt::format("Ctrl-C ends  {:.1f} s  {:.3g}x  {}  {}", time, speed, subgoals, state);
}

/// The guide, where it explores: what it has found so far shows while it drives.
std::shared_ptr<const SonarExplorer> explorer_of(const PilotTable& pilot) {
  if (!pilot.guide || !pilot.guide->object) return nullptr;
  return explorer_of(*static_cast<const Guide*>(pilot.guide->object));
}

std::vector<RobotLook> looks_of(const Sim& sim) {
  std::vector<RobotLook> looks;
  for (std::size_t k = 0; k < sim.robot_count(); ++k) looks.push_back(look_of(sim.robot(k)));
  return looks;
}

Moment moment_of(const Sim& sim) {
  Moment moment;
  moment.time = sim.time();
  for (std::size_t k = 0; k < sim.robot_count(); ++k) {
    moment.poses.push_back(sim.state(k).pose_world);
    moment.ranges.push_back(sim.observation(k).readings.sonar);
  }
  moment.scanned_from = moment.poses;
  const std::vector<Pole>& moving = sim.scene().moving;  // robots first
  for (std::size_t i = sim.robot_count(); i < moving.size(); ++i) moment.movers.push_back(moving[i].disc);
  return moment;
}

/// A drive in a picture.
class WatchedDrive {
 public:
  WatchedDrive(const std::shared_ptr<Sim>& sim, const WatchTable& table)
      : sim_(*sim), picture_(*sim->shared_world(), looks_of(*sim)) {
    // Subgoals that are listed show from the beginning, others as the guide gives them.
    std::vector<PilotTable> tables = table.pilots.value_or(std::vector<PilotTable>{table});
    for (const PilotTable& pilot : tables) {
      std::vector<Subgoal> listed;
      for (const SubgoalOption& option : pilot.subgoals) listed.push_back(option.in(&sim->world()));
      listed_.push_back(std::move(listed));
      explorers_.push_back(explorer_of(pilot));
    }
    picture_.on_ground = [this](DrawList& list, const Theme& theme) {
      for (const auto& explorer : explorers_)
        if (explorer) draw_indicators(list, explorer->explorer().graph(), theme);
    };
  }

  LivePicture& picture() { return picture_; }

  /// The robots have arrived where they are now.
  void pass() {
    for (std::size_t k = 0; k < sim_.robot_count(); ++k)
      picture_.pass(k, sim_.state(k).pose_world, sim_.state(k).touching);
  }

  Moment moment(const Drive& drive) {
    picture_.follow(sim_.world());
    for (std::size_t k = 0; k < drive.pilots(); ++k) {
      const Run& run = drive.run(k);
      std::vector<TrackGoal> goals;
      if (explorers_[k]) {  // where it is going; where it has been its graph shows
        if (!run.goals.empty()) picture_.set_goals(k, {goal_of(run.goals.back(), false)});
        continue;
      }
      for (const Subgoal& subgoal : listed_[k].empty() ? run.goals : listed_[k])
        goals.push_back(goal_of(subgoal, std::ssize(goals) < run.reached));
      picture_.set_goals(k, std::move(goals));
    }
    return moment_of(sim_);
  }

  std::string line(const Drive& drive, double speed) const {
    const RobotState& state = sim_.state();
    return line_text(drive.time(), speed, subgoals_text(drive), state_text(state.v, state.clearance, state.touching));
  }

 private:
  const Sim& sim_;
  LivePicture picture_;
  std::vector<std::vector<Subgoal>> listed_;
  std::vector<std::shared_ptr<const SonarExplorer>> explorers_;  ///< by robot; nullptr: another guide
};

/// A recorded run in a picture.
class WatchedRun {
 public:
  explicit WatchedRun(const RunRecord& record)
      : run_(record.run), picture_(*record.world, {look_of(record.run.robot)}) {}

  LivePicture& picture() { return picture_; }

  /// The robot has arrived where it was after this cycle.
  void pass(const RunStep& step) { picture_.pass(0, step.pose_world, step.touching); }

  Moment moment(const RunStep& step) {
    // When a subgoal was reached is not recorded: it was near.
    const auto reached = static_cast<std::size_t>(reached_);
    if (reached_ < run_.reached && reached < run_.goals.size() &&
        (run_.goals[reached].position - step.pose_world.position()).norm() <= run_.goals[reached].tolerance)
      ++reached_;
    std::vector<TrackGoal> goals;
    for (const Subgoal& subgoal : run_.goals) goals.push_back(goal_of(subgoal, std::ssize(goals) < reached_));
    picture_.set_goals(0, std::move(goals));
    return {.time = step.time,
            .poses = {step.pose_world},
            .scanned_from = {step.pose_world},
            .ranges = {std::vector<double>(step.sonar.begin(), step.sonar.end())},
            .movers = {}};
  }

  std::string line(const RunStep& step, double speed) const {
    const std::string subgoals = run_.subgoals > 0 ? fmt::format("{}/{} subgoals", reached_, run_.subgoals)
                                                   : fmt::format("{} subgoals", reached_);
    return line_text(step.time, speed, subgoals, state_text(step.v, step.clearance, step.touching));
  }

 private:
  const Run& run_;
  LivePicture picture_;
  int reached_ = 0;
};

void reject_drive_options(const WatchTable& table) {
  const char* given = table.navigator           ? "navigator"
                      : table.guide             ? "guide"
                      : !table.subgoals.empty() ? "subgoals"
                      : table.pilots            ? "pilots"
                      : table.on_step           ? "on_step"
                                                : nullptr;
  if (given) fail("option '{}': not for a run, which is over; 'speed' and 'rate' are", given);
}

}  // namespace

Speed Lua<Speed>::read(lua_State* L, int index, const Path& path) {
  if (lua_type(L, index) != LUA_TNUMBER || !(lua_tonumber(L, index) >= 0))
    expected(L, index, path, "number >= 0 (0 or math.huge: as fast as it goes)");
  return {lua_tonumber(L, index)};
}

std::shared_ptr<DriveRuns> watch_drive(const std::shared_ptr<Sim>& sim, const WatchTable& table, const Call& call) {
  Driving driving(sim, table, call);
  WatchedDrive watched(sim, table);
  Moment moment = watched.moment(driving.state());
  watched.pass();
  {
    LiveView view(call, speed_of(table), table.rate, [&] { return watched.picture().at(moment); });
    while (driving.step()) {
      const Moment before = std::exchange(moment, watched.moment(driving.state()));
      view.pass(watched.picture(), before, moment, [&] { return watched.line(driving.state(), view.speed()); });
      watched.pass();
      if (!view.live()) driving.report();
    }
  }
  return driving.finish();
}

void watch_run(const RunRecord& record, const WatchTable& table, const Call& call) {
  reject_drive_options(table);
  const std::vector<RunStep>& steps = record.run.steps;
  if (steps.empty()) fail("the run keeps no steps to show (record_every = 0)");
  WatchedRun watched(record);
  Moment moment = watched.moment(steps.front());
  {
    LiveView view(call, speed_of(table), table.rate, [&] { return watched.picture().at(moment); });
    for (const RunStep& step : steps) {
      const Moment before = std::exchange(moment, watched.moment(step));
      view.pass(watched.picture(), before, moment, [&] { return watched.line(step, view.speed()); });
      watched.pass(step);
    }
  }
}

}  // namespace meander::script
