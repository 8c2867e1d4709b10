// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sim/sim.hpp"

#include <algorithm>
#include <cmath>

#include "sim/start.hpp"

namespace meander {
namespace {

/// A cycle is driven in equal parts of at most this length [s]: 1.5 cm at the Nomad's full speed.
constexpr double kPart = 0.025;
constexpr double kLeastPeriod = 0.001;  ///< [s] as of platforms

std::uint64_t robot_seed(std::uint64_t seed, std::size_t robot) {
  return robot == 0 ? seed : Hash().add(seed).add("robot").add(std::uint64_t{robot}).value();
}

}  // namespace

Sim::Sim(std::shared_ptr<World> world, std::vector<RobotOptions> robots, SimOptions options)
    : world_(std::move(world)), options_(options), clock_(options.seed, "clock") {
  if (!world_) fail("a world expected, got none");
  if (robots.empty()) fail("at least one robot expected, got none");
  validate(options_);
  if (options_.period != 0 && options_.period < kLeastPeriod)
    fail("period: 0 (the platform's own) or at least {} s expected, got {}", kLeastPeriod, options_.period);
  period_ = options_.period > 0 ? options_.period : robots.front().platform.period;
  start(robots, options_.seed);
}

void Sim::start(const std::vector<RobotOptions>& robots, std::uint64_t seed) {
  const std::vector<Pose2> starts = checked_starts(*world_, robots);
  std::vector<SimRobot> fresh;
  fresh.reserve(robots.size());
  for (std::size_t k = 0; k < robots.size(); ++k)
    fresh.emplace_back(robots[k], starts[k], Scene::kMovingOwner + static_cast<std::uint32_t>(k),
                       options_.command_delay, robot_seed(seed, k));
  robots_ = std::move(fresh);
  options_.seed = seed;
  clock_ = Stream(seed, "clock");
  time_ = 0;
  movers_.restart(seed);
  seen_ = ~std::uint64_t{0};
  follow_edits();
  for (SimRobot& robot : robots_) robot.sense(scene_, time_, period_);
}

void Sim::follow_edits() {
  if (seen_ == world_->revision()) return;
  scene_.follow(*world_);
  movers_.follow(*world_);
  for (SimRobot& robot : robots_) robot.look_again(scene_);
  seen_ = world_->revision();
  place_moving();
}

void Sim::place_moving() {
  const auto states = movers_.states();
  scene_.moving.resize(robots_.size() + states.size());
  strides_.resize(scene_.moving.size());
  for (std::size_t k = 0; k < scene_.moving.size(); ++k) {
    Pole& pole = scene_.moving[k];
    pole.owner = Scene::kMovingOwner + static_cast<std::uint32_t>(k);
    const bool robot = k < robots_.size();
    const std::size_t i = k - robots_.size();
    pole.disc = robot ? Disc{robots_[k].state().pose_world.position(), robots_[k].radius()}
                      : Disc{states[i].position, movers_.radius(i)};
    strides_[k] = robot ? robots_[k].stride() : movers_.stride(i);
  }
}

double Sim::next_period() {
  if (options_.period_jitter == 0) return period_;
  return period_ * std::clamp(clock_.normal(1, options_.period_jitter), 0.1, 3.0);
}

void Sim::step(std::span<const Command> commands) {
  if (commands.size() != robots_.size())
    fail("one command per robot expected: {}, got {}", robots_.size(), commands.size());
  follow_edits();
  const double period = next_period();
  const int parts = std::max(1, static_cast<int>(std::ceil(period / kPart - 1e-9)));
  const double dt = period / parts;
  for (std::size_t k = 0; k < robots_.size(); ++k) robots_[k].begin_cycle(commands[k], period);
  movers_.wander(period);
  for (int part = 0; part < parts; ++part) {
    movers_.advance(dt, scene_.walls(), world_->header().bounds, {scene_.moving.data(), robots_.size()});
    place_moving();
    for (std::size_t k = 0; k < robots_.size(); ++k) {
      robots_[k].move(scene_, strides_, dt);
      scene_.moving[k].disc.center = robots_[k].state().pose_world.position();
      strides_[k] = robots_[k].stride();
    }
  }
  time_ += period;
  for (SimRobot& robot : robots_) robot.sense(scene_, time_, period);
}

const Observation& Sim::step(const Command& command) {
  step({&command, 1});
  return observation();
}

void Sim::reset() { reset(options_.seed); }

void Sim::reset(std::uint64_t seed) {
  std::vector<RobotOptions> robots;
  for (const SimRobot& robot : robots_) robots.push_back(robot.options());
  start(robots, seed);
}

Sim Sim::fork() const {
  Sim copy = *this;
  copy.world_ = std::make_shared<World>(*world_);
  return copy;
}

std::uint64_t Sim::world_hash() const {
  if (hashed_revision_ != world_->revision()) {
    world_hash_ = world_->hash();
    hashed_revision_ = world_->revision();
  }
  return world_hash_;
}

std::uint64_t Sim::hash() const {
  Hash hash;
  hash.add(world_hash()).add(options_.seed).add(time_);
  for (const SimRobot& robot : robots_) robot.add_to(hash);
  movers_.add_to(hash);
  clock_.add_to(hash);
  return hash.value();
}

}  // namespace meander
