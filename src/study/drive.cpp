// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/drive.hpp"

#include <algorithm>

#include "study/seat.hpp"

namespace meander {

Drive::Drive(Sim& sim, std::span<const Pilot> pilots, const DriveOptions& options)
    : sim_(sim), options_(options), start_(sim.time()), commands_(sim.robot_count()) {
  validate(options);
  if (pilots.size() > sim.robot_count())
    fail("at most one pilot per robot expected: {}, got {}", sim.robot_count(), pilots.size());
  for (std::size_t k = 0; k < pilots.size(); ++k) seats_.emplace_back(sim, pilots[k], k);
}

Drive::~Drive() = default;

bool Drive::step() {
  for (std::size_t k = 0; k < seats_.size(); ++k) commands_[k] = seats_[k].command(sim_);
  if (finished()) return false;
  if (time() >= options_.time_limit - 1e-9) {
    stop(fmt::format("time limit of {:g} s", options_.time_limit));
    return false;
  }
  sim_.step(commands_);
  for (Seat& seat : seats_) seat.record(sim_, options_);
  return true;
}

void Drive::stop(const std::string& reason) {
  for (Seat& seat : seats_) seat.finish(reason);
}

bool Drive::finished() const {
  return std::all_of(seats_.begin(), seats_.end(), [](const Seat& seat) { return seat.finished(); });
}

double Drive::time() const { return sim_.time() - start_; }

double Drive::progress() const {
  double least = 1;
  for (const Seat& seat : seats_) least = std::min(least, seat.progress());
  return std::clamp(std::max(least, time() / options_.time_limit), 0.0, 1.0);
}

std::size_t Drive::pilots() const { return seats_.size(); }

const Run& Drive::run(std::size_t pilot) const { return seats_.at(pilot).run(); }

std::vector<Run> Drive::results() {
  std::vector<Run> runs;
  for (Seat& seat : seats_) runs.push_back(seat.result(sim_));
  return runs;
}

std::vector<Run> drive(Sim& sim, std::span<const Pilot> pilots, const DriveOptions& options, const Work& work,
                       const OnStep& on_step) {
  Drive drive(sim, pilots, options);
  while (work.poll(), drive.step()) {
    if (on_step && !on_step(sim)) drive.stop("stopped by on_step");
    work.report(drive.progress(), "driving");
  }
  return drive.results();
}

Run drive(Sim& sim, const Navigator& navigator, const Guide& guide, const DriveOptions& options, const Work& work,
          const OnStep& on_step) {
  const Pilot pilot{navigator, guide};
  return std::move(drive(sim, {&pilot, 1}, options, work, on_step).front());
}

}  // namespace meander
