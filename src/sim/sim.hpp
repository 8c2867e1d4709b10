// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "base/random.hpp"
#include "sensor/scene.hpp"
#include "sim/mover_state.hpp"
#include "sim/movers.hpp"
#include "sim/sim_robot.hpp"
#include "world/world.hpp"

namespace meander {

struct SimOptions {
  std::uint64_t seed = 1;
  double period = 0;         ///< control cycle [s]; 0: the first robot's platform's own
  double period_jitter = 0;  ///< standard deviation of the period, as a share of it
  int command_delay = 0;     ///< cycles until a command takes effect
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SimOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"seed", "", "seed of all random streams", 0, 1.8446744073709552e19}, o.seed);
  visit(Field{"period", "s", "control cycle; 0: the platform's own", 0, 10}, o.period);
  visit(Field{"period_jitter", "", "standard deviation of the control cycle, as a share of it", 0, 1}, o.period_jitter);
  visit(Field{"command_delay", "", "cycles until a command takes effect", 0, 1000}, o.command_delay);
}

/// The loop: command in, observation out. Knows no algorithm. A value: copying it forks it (a plain copy shares the
/// world, so that edits reach both; fork() copies the world too). Edits of the world take effect at the next step. What
/// a step does, in order: docs/simulation.md.
class Sim {
 public:
  /// Throws ArgumentError when there is no robot, an option is out of range or a start is not free.
  Sim(std::shared_ptr<World> world, std::vector<RobotOptions> robots, SimOptions options);

  /// The observation before the first step / of the last step.
  const Observation& observation(std::size_t robot = 0) const { return robots_.at(robot).observation(); }

  /// One control cycle of all robots: kinematics with acceleration limits, movers, contact, drift, scan, bumpers.
  void step(std::span<const Command> commands);
  const Observation& step(const Command& command);  ///< of a single-robot simulation

  /// Back to the start, same seed: the same run again, in the world as it is now. A new seed gives another.
  void reset();
  void reset(std::uint64_t seed);
  /// An independent copy with its own copy of the world.
  Sim fork() const;
  /// Of everything that decides how the run goes on: world, robots, sensors, movers, random streams.
  std::uint64_t hash() const;

  double time() const { return time_; }
  double period() const { return period_; }
  const SimOptions& options() const { return options_; }
  std::size_t robot_count() const { return robots_.size(); }
  const RobotOptions& robot(std::size_t robot = 0) const { return robots_.at(robot).options(); }
  const RobotState& state(std::size_t robot = 0) const { return robots_.at(robot).state(); }
  const World& world() const { return *world_; }
  const std::shared_ptr<World>& shared_world() const { return world_; }
  const Scene& scene() const { return scene_; }
  std::span<const MoverState> movers() const { return movers_.states(); }

 private:
  void start(const std::vector<RobotOptions>& robots, std::uint64_t seed);
  void follow_edits();
  double next_period();
  void place_moving();
  std::uint64_t world_hash() const;

  std::shared_ptr<World> world_;
  SimOptions options_;
  double period_ = 0.33;
  double time_ = 0;
  Scene scene_;
  std::uint64_t seen_ = 0;  ///< edits of the world that have taken effect
  std::vector<SimRobot> robots_;
  Movers movers_;
  Stream clock_;
  std::vector<Vec2> strides_;  ///< ways [m] that the moving discs want to go, in the order of scene_.moving
  mutable std::uint64_t hashed_revision_ = ~std::uint64_t{0};
  mutable std::uint64_t world_hash_ = 0;
};

}  // namespace meander
