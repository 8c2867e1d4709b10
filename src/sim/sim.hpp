// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "robot/contracts.hpp"
#include "robot/drift.hpp"
#include "robot/kinematics.hpp"
#include "robot/platform.hpp"
#include "sensor/scene.hpp"
#include "sensor/sonar.hpp"
#include "sim/mover_state.hpp"
#include "world/world.hpp"

namespace meander {

/// One robot of a simulation.
struct RobotOptions {
  Platform platform;
  SonarOptions sonar;
  DriftOptions drift;
  std::optional<Pose2> start;  ///< none: the world's start
};

struct SimOptions {
  std::uint64_t seed = 1;
  double period = 0;          ///< control cycle [s]; 0: the first robot's platform's own
  double period_jitter = 0;   ///< standard deviation of the period, as a share of it
  int command_delay = 0;      ///< cycles until a command takes effect
};

/// True state of one robot, for pictures and scores; never handed to the robot side.
struct RobotState {
  Pose2 pose_world;
  double v = 0;
  double w = 0;
  bool touching = false;   ///< in contact at the end of the cycle
  int contacts = 0;        ///< contact episodes so far
  int fault_contacts = 0;  ///< of these, by the robot's own motion
  double travelled = 0;    ///< [m]
  double clearance = 0;    ///< hull to nearest obstacle now [m], at most kClearanceSeen
};
inline constexpr double kClearanceSeen = 10;

/// The loop: command in, observation out. Knows no algorithm. A value: copying it forks it (give the copy its own world
/// with share(), or edits reach both). Edits of the world take effect at the next step.
class Sim {
 public:
  Sim(std::shared_ptr<World> world, std::vector<RobotOptions> robots, SimOptions options);

  /// The observation before the first step / of the last step.
  const Observation& observation(std::size_t robot = 0) const { return robots_.at(robot).observation; }

  /// One control cycle of all robots: kinematics with acceleration limits, movers, contact, drift, scan, bumpers.
  void step(std::span<const Command> commands);
  const Observation& step(const Command& command);  ///< of a single-robot simulation

  /// Back to the start, same seed: the same run again. A new seed gives another.
  void reset();
  void reset(std::uint64_t seed);
  /// An independent copy with its own copy of the world.
  Sim fork() const;
  std::uint64_t hash() const;

  double time() const { return time_; }
  double period() const { return period_; }
  const SimOptions& options() const { return options_; }
  std::size_t robot_count() const { return robots_.size(); }
  const RobotOptions& robot(std::size_t robot = 0) const { return robots_.at(robot).options; }
  const RobotState& state(std::size_t robot = 0) const { return robots_.at(robot).state; }
  const World& world() const { return *world_; }
  const std::shared_ptr<World>& shared_world() const { return world_; }
  const Scene& scene() const { return scene_; }
  std::span<const MoverState> movers() const { return movers_; }

 private:
  struct Robot {
    RobotOptions options;
    SonarRing sonar;
    Drift drift;
    RobotState state;
    Observation observation;
    std::vector<Command> pending;     ///< delayed commands, oldest first
    std::vector<Pose2> trajectory;    ///< true poses at the sub-steps of the cycle
    std::vector<Pose2> firing_poses;  ///< true pose at each transducer's firing
  };

  std::shared_ptr<World> world_;
  SimOptions options_;
  double period_ = 0.33;
  double time_ = 0;
  Scene scene_;
  std::vector<Robot> robots_;
  std::vector<MoverState> movers_;
  Stream clock_;
  Stream mover_stream_;
};

}  // namespace meander
