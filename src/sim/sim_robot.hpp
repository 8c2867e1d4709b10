// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "robot/contracts.hpp"
#include "robot/drift.hpp"
#include "robot/platform.hpp"
#include "sensor/light.hpp"
#include "sensor/scene.hpp"
#include "sensor/sonar.hpp"
#include "sensor/whisker.hpp"
#include "sim/contact.hpp"

namespace meander {

/// One robot of a simulation.
struct RobotOptions {
  Platform platform;
  SonarOptions sonar;
  DriftOptions drift;
  WhiskerOptions whisker;
  LightSensorOptions light;
  std::optional<Pose2> start;  ///< none: the world's start
};

/// True state of one robot, for pictures and scores; never handed to the robot side.
struct RobotState {
  Pose2 pose_world;
  double v = 0;
  double w = 0;
  double vy = 0;           ///< to the left; 0 for unicycles
  bool touching = false;   ///< in contact at the end of the cycle
  int contacts = 0;        ///< contact episodes so far
  int fault_contacts = 0;  ///< of these, by the robot's own motion
  double travelled = 0;    ///< [m]
  double clearance =
      0;  ///< hull to nearest obstacle now [m], at most kClearanceSeen; negative: an edit put one onto it
};
inline constexpr double kClearanceSeen = 10;

/// A robot's body, wheels and sensors in the world. Copying it forks it.
class SimRobot {
 public:
  SimRobot(const RobotOptions& options, const Pose2& start, std::uint32_t self, int command_delay, std::uint64_t seed);

  /// A cycle of `period` seconds begins: the command joins the queue, the one whose time has come takes effect.
  void begin_cycle(const Command& command, double period);
  /// `dt` seconds of motion: velocity ramp, exact arc, contact. `strides` are the ways [m] that the moving discs of the
  /// scene want to go in this part of the cycle.
  void move(const Scene& scene, std::span<const Vec2> strides, double dt);
  /// Clearance and contact at the end of the cycle, then all sensors.
  void sense(const Scene& scene, double time, double period);
  /// The walls of the scene have changed.
  void look_again(const Scene& scene);

  const RobotOptions& options() const { return options_; }
  const RobotState& state() const { return state_; }
  const Observation& observation() const { return observation_; }
  double radius() const { return options_.platform.body.radius; }
  /// The way it wanted to go last [m].
  const Vec2& stride() const { return stride_; }
  void add_to(Hash& hash) const;

 private:
  double way(const Scene& scene, std::span<const Vec2> strides, const Vec2& by);
  double way_among_walls(const ShapeIndex& walls, const Vec2& by);
  double way_out_of_solid(const ShapeIndex& walls, const Vec2& by) const;
  void touch(bool own_fault);
  void measure_clearance(const Scene& scene);
  void scan(const Scene& scene);
  void add_further(Hash& hash) const;

  RobotOptions options_;
  std::uint32_t self_;  ///< owner number in scene.moving
  SonarRing sonar_;
  WhiskerRing whiskers_;
  LightRing lights_;
  Drift drift_;
  RobotState state_;
  Observation observation_;
  std::vector<Command> queue_;  ///< delayed commands, oldest first
  Command command_;             ///< in force
  Vec2 stride_{0, 0};
  bool in_contact_ = false;  ///< an episode is going on
  bool buried_ = false;      ///< an edit put a solid over the centre
  double room_ = 0;          ///< no wall is nearer to the hull than this [m]
  double reach_ = 0;         ///< longest way of the cycle [m]
  bool near_known_ = false;  ///< near_ holds for the rest of the cycle
  Surroundings near_;
  std::vector<Pose2> track_world_;     ///< true poses at the parts of the cycle, its start included
  std::vector<Pose2> track_odometry_;  ///< the same as dead reckoning tells them
  std::vector<Pose2> firing_world_;    ///< true pose at each sonar's firing
};

}  // namespace meander
