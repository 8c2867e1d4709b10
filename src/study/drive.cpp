// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/drive.hpp"

#include <time.h>

#include <algorithm>

#include "study/metrics.hpp"

namespace meander {
namespace {

/// CPU time of this thread [s]. Goes into cpu_per_cycle alone, never into anything that decides.
double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool same_place(const Subgoal& a, const Subgoal& b) { return a.position == b.position && a.name == b.name; }

/// One pilot in its seat: asks, commands, records.
class Seat {
 public:
  Seat(const Sim& sim, const Pilot& pilot, std::size_t robot)
      : pilot_(pilot), robot_(robot), start_time_(sim.time()), metrics_(sim.state(robot), sim.time()) {
    run_.navigator = pilot.navigator.name;
    run_.guide = pilot.guide.name;
    run_.seed = sim.options().seed;
    run_.subgoals = pilot.guide.subgoals;
    run_.world_hash = sim.world().hash();
    run_.robot = sim.robot(robot);
    run_.sim = sim.options();
    run_.robot_radius = run_.robot.platform.body.radius;
    pilot.navigator.reset();
    pilot.guide.reset();
  }

  bool finished() const { return finished_; }
  double progress() const { return run_.subgoals > 0 ? static_cast<double>(run_.reached) / run_.subgoals : 0; }

  /// The command of this cycle; zero once the guide has finished.
  Command command(const Sim& sim) {
    if (finished_) return {};
    const double before = cpu_time();
    ask(sim.observation(robot_));
    cpu_ += cpu_time() - before;
    return finished_ ? Command{} : last_.command;
  }

  void record(const Sim& sim, const DriveOptions& options) {
    if (finished_) return;
    const RobotState& state = sim.state(robot_);
    metrics_.add(state, sim.time(), sim.observation(robot_).period);
    hash_.add(sim.hash());
    ++cycles_;
    if (options.record_every > 0 && cycles_ % options.record_every == 0) run_.steps.push_back(run_step(sim, state));
    if (options.stop_on_contact && state.contacts > metrics_.contacts_before()) finish("contact");
  }

  void finish(const std::string& reason) {
    if (finished_) return;
    finished_ = true;
    run_.reason = reason;
  }

  Run result(const Sim& sim) {
    metrics_.write(run_);
    run_.cpu_per_cycle = cycles_ > 0 ? cpu_ / cycles_ : 0;
    run_.hash = cycles_ > 0 ? hash_.value() : sim.hash();
    return std::move(run_);
  }

 private:
  void ask(const Observation& observation) {
    const GuideStep where = pilot_.guide.next(observation, last_);
    run_.reached = where.reached;
    if (!where.subgoal) {
      run_.success = where.success;
      return finish(where.reason);
    }
    if (run_.goals.empty() || !same_place(run_.goals.back(), *where.subgoal)) run_.goals.push_back(*where.subgoal);
    last_ = pilot_.navigator.step(observation, *where.subgoal);
  }

  RunStep run_step(const Sim& sim, const RobotState& state) const {
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
            .sonar = {sonar.begin(), sonar.end()}};
  }

  const Pilot& pilot_;
  std::size_t robot_;
  double start_time_;
  Metrics metrics_;
  Run run_;
  NavigatorStep last_;
  Hash hash_;
  double cpu_ = 0;
  int cycles_ = 0;
  bool finished_ = false;
};

bool all_finished(const std::vector<Seat>& seats) {
  return std::all_of(seats.begin(), seats.end(), [](const Seat& seat) { return seat.finished(); });
}

void finish_all(std::vector<Seat>& seats, const std::string& reason) {
  for (Seat& seat : seats) seat.finish(reason);
}

double progress(const std::vector<Seat>& seats, double time_share) {
  double least = 1;
  for (const Seat& seat : seats) least = std::min(least, seat.progress());
  return std::clamp(std::max(least, time_share), 0.0, 1.0);
}

}  // namespace

std::vector<Run> drive(Sim& sim, std::span<const Pilot> pilots, const DriveOptions& options, const Work& work,
                       const OnStep& on_step) {
  validate(options);
  if (pilots.size() > sim.robot_count())
    fail("at most one pilot per robot expected: {}, got {}", sim.robot_count(), pilots.size());
  std::vector<Seat> seats;
  for (std::size_t k = 0; k < pilots.size(); ++k) seats.emplace_back(sim, pilots[k], k);
  std::vector<Command> commands(sim.robot_count());
  const double start = sim.time();
  for (;;) {
    work.poll();
    for (std::size_t k = 0; k < seats.size(); ++k) commands[k] = seats[k].command(sim);
    if (all_finished(seats)) break;
    if (sim.time() - start >= options.time_limit - 1e-9) {
      finish_all(seats, fmt::format("time limit of {:g} s", options.time_limit));
      break;
    }
    sim.step(commands);
    for (Seat& seat : seats) seat.record(sim, options);
    if (on_step && !on_step(sim)) finish_all(seats, "stopped by on_step");
    work.report(progress(seats, (sim.time() - start) / options.time_limit), "driving");
  }
  std::vector<Run> runs;
  for (Seat& seat : seats) runs.push_back(seat.result(sim));
  return runs;
}

Run drive(Sim& sim, const Navigator& navigator, const Guide& guide, const DriveOptions& options, const Work& work,
          const OnStep& on_step) {
  const Pilot pilot{navigator, guide};
  return std::move(drive(sim, {&pilot, 1}, options, work, on_step).front());
}

}  // namespace meander
