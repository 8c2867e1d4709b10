// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/seat.hpp"

#include <time.h>

#include <utility>

namespace meander {
namespace {

/// CPU time of this thread [s]. Goes into cpu_per_cycle alone, never into anything that decides.
double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool same_place(const Subgoal& a, const Subgoal& b) { return a.position == b.position && a.name == b.name; }

}  // namespace

Seat::Seat(const Sim& sim, Pilot pilot, std::size_t robot)
    : pilot_(std::move(pilot)), robot_(robot), start_time_(sim.time()), metrics_(sim.state(robot), sim.time()) {
  check_body(pilot_.navigator, sim.robot(robot).platform.body.radius);
  run_.navigator = pilot_.navigator.name;
  run_.guide = pilot_.guide.name;
  run_.seed = sim.options().seed;
  run_.subgoals = pilot_.guide.subgoals;
  run_.world_hash = sim.world().hash();
  run_.robot = sim.robot(robot);
  run_.sim = sim.options();
  run_.robot_radius = run_.robot.platform.body.radius;
  pilot_.navigator.reset();
  pilot_.guide.reset();
}

Command Seat::command(const Sim& sim) {
  if (finished_) return {};
  const double before = cpu_time();
  ask(sim.observation(robot_));
  cpu_ += cpu_time() - before;
  return finished_ ? Command{} : last_.command;
}

void Seat::record(const Sim& sim, const DriveOptions& options) {
  if (finished_) return;
  const RobotState& state = sim.state(robot_);
  metrics_.add(state, sim.time(), sim.observation(robot_).period);
  hash_.add(sim.hash());
  ++cycles_;
  // Navigators that go on freeing themselves give a reason while they drive.
  const bool trapped = last_.status == NavigatorStatus::trapped || !last_.reason.empty();
  run_.trapped += trapped && !trapped_;
  trapped_ = trapped;
  if (options.record_every > 0 && cycles_ % options.record_every == 0) run_.steps.push_back(run_step(sim, state));
  if (options.stop_on_contact && state.contacts > metrics_.contacts_before()) finish("contact");
}

void Seat::finish(const std::string& reason) {
  if (finished_) return;
  finished_ = true;
  run_.reason = reason;
}

Run Seat::result(const Sim& sim) {
  metrics_.write(run_);
  run_.cpu_per_cycle = cycles_ > 0 ? cpu_ / cycles_ : 0;
  run_.hash = cycles_ > 0 ? hash_.value() : sim.hash();
  return std::move(run_);
}

void Seat::ask(const Observation& observation) {
  const GuideStep where = pilot_.guide.next(observation, last_);
  run_.reached = where.reached;
  if (!where.subgoal) {
    run_.success = where.success;
    return finish(where.reason);
  }
  if (run_.goals.empty() || !same_place(run_.goals.back(), *where.subgoal)) run_.goals.push_back(*where.subgoal);
  last_ = pilot_.navigator.step(observation, *where.subgoal);
}

RunStep Seat::run_step(const Sim& sim, const RobotState& state) const {
  const Observation& observation = sim.observation(robot_);
  const auto& sonar = observation.readings.sonar;
  return {.time = sim.time() - start_time_,
          .pose_world = state.pose_world,
          .odometry = observation.odometry.pose,
          .command = last_.command,
          .v = state.v,
          .w = state.w,
          .clearance = state.clearance,
          .touching = state.touching,
          .status = last_.status,
          .sonar = {sonar.begin(), sonar.end()},
          .whisker = observation.readings.whisker,
          .light = observation.readings.light};
}

}  // namespace meander
