// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "polar/point_mapper.hpp"
#include "polar/polar_options.hpp"
#include "robot/contracts.hpp"

namespace meander {

/// The local navigator of [LM99]: sonar short-term memory, configuration prediction, polar neural map, motion control.
class PolarNavigator {
 public:
  PolarNavigator(const Platform& platform, const PolarOptions& options, PolarParts parts = {});
  PolarNavigator(const PolarNavigator&) = delete;
  PolarNavigator& operator=(const PolarNavigator&) = delete;

  NavigatorStep step(const Observation& observation, const Subgoal& subgoal);
  /// As if new.
  void reset();

  /// Has made a map since it began: what follows tells something.
  bool mapped() const { return mapped_; }
  // What the last cycle was like, to look inside.
  const PolarOptions& options() const { return options_; }
  const PolarLayout& layout() const { return layout_; }
  const PolarSolver& solver() const { return solver_; }
  const SonarMemory& memory() const { return memory_; }
  const ObstructedUnits& obstructed() const { return *planned_; }
  const Prediction& predicted() const { return predicted_; }
  const Pose2& odometry_from_map() const { return odometry_from_map_; }
  std::span<const MappedPoint> points() const { return mapper_.points(); }
  const std::optional<PolarSubgoal>& subgoal() const { return subgoal_; }
  Vec2 target() const { return {target_distance_, 0}; }  ///< in the frame of the map
  int target_ring() const { return target_ring_; }
  const MotionControl& control() const { return control_; }
  const Platform& platform() const { return platform_; }
  const TrapEscapes& trap() const { return trap_; }
  const Predictor& predictor() const { return predictor_; }

 private:
  void check_decay();
  NavigatorStep arrive(const Observation& observation, const Subgoal& subgoal) const;
  void place_map(const Vec2& target);
  void map_points(const Observation& observation);
  void organise();
  void project();
  void diffuse();
  bool reached() const;
  void retry(int scans);
  void choose_subgoal();
  Command drive();
  Command turn_in_place() const;

  Platform platform_;
  PolarOptions options_;
  PolarParts parts_;
  PolarLayout layout_;
  std::optional<LayoutOrganiser> organiser_;  ///< of a layout that is not fixed
  SonarMemory memory_;
  Predictor predictor_;
  PointMapper mapper_;
  std::vector<Vec2> obstacles_;  ///< of one's own, as of this cycle
  PolarLayout control_layout_;   ///< never moves
  Projection projection_;        ///< layers: plan, hard, soft
  Projection narrow_;            ///< plan with the narrow margin
  Projection organised_;         ///< plan in a layout that is not fixed
  PolarSolver solver_;
  std::vector<RingWeights> arranged_;  ///< as the organiser places the rings
  SubgoalReadout readout_;
  MotionControl control_;
  TrapEscapes trap_;

  bool mapped_ = false;
  Prediction predicted_;
  Pose2 odometry_from_map_;
  double target_distance_ = 0;
  int target_ring_ = 0;
  const ObstructedUnits* planned_;  ///< the layer that the activation went around
  std::optional<PolarSubgoal> subgoal_;
  std::optional<double> direction_;  ///< of the last subgoal, in the odometry frame [rad]
};

/// A navigator for this platform. Throws ArgumentError when an option is out of range or weights of one's own have no
/// stable equilibrium.
Navigator polar_navigator(const Platform& platform, const PolarOptions& options = {}, PolarParts parts = {});
/// The polar navigator inside, if it is one.
std::shared_ptr<const PolarNavigator> polar_inside(const Navigator& navigator);

}  // namespace meander
