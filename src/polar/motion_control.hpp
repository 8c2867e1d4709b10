// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <vector>

#include "polar/prediction.hpp"
#include "polar/projection.hpp"

namespace meander {

struct MotionControlOptions {
  int speeds = 11;
  int turns = 21;
  double hard_margin = 0.07;
  double soft_margin = 0.30;
  double heading_cost = 0.4;
  double heading_reach = 0.15;
  double hard_cost = 10;
  double hard_base = 0.2;
  double hard_samples = 0.2;
  double soft_samples = 0.1;
  double soft_speed_cost = 2;
  double soft_speed = 0.3;
  double near_margin = 0.20;
  double sample_step = 0.05;
  int samples = 12;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MotionControlOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"speeds", "", "forward speeds tried in the dynamic window", 2, 1000}, o.speeds);
  visit(Field{"turns", "", "turning rates tried in the dynamic window", 2, 1000}, o.turns);
  visit(Field{"hard_margin", "m", "the hull must not come nearer to a point than this", 0, 10}, o.hard_margin);
  visit(Field{"soft_margin", "m", "nearer than this the robot goes slowly", 0, 10}, o.soft_margin);
  visit(Field{"heading_cost", "m/rad", "cost of not facing the subgoal in the end", 0, 1000}, o.heading_cost);
  visit(Field{"heading_reach", "m", "nearer to the subgoal than this the heading matters less", 1e-6, 100},
        o.heading_reach);
  visit(Field{"hard_cost", "m", "cost of coming too near", 0, 1e6}, o.hard_cost);
  visit(Field{"hard_base", "", "share of that cost at standstill; the rest grows with the speed", 0, 10}, o.hard_base);
  visit(Field{"hard_samples", "m", "cost of each sample of the trajectory that is too near", 0, 1000}, o.hard_samples);
  visit(Field{"soft_samples", "m", "cost of eight samples in the slow zone", 0, 1000}, o.soft_samples);
  visit(Field{"soft_speed_cost", "m", "cost of driving at full speed above soft_speed in the slow zone", 0, 1000},
        o.soft_speed_cost);
  visit(Field{"soft_speed", "m/s", "speed in the slow zone that costs nothing", 0, 100}, o.soft_speed);
  visit(Field{"near_margin", "m",
              "a robot that stands nearer to a point than this is in the slow zone wherever it goes", 0, 10},
        o.near_margin);
  visit(Field{"sample_step", "m", "distance between samples of a trajectory", 1e-3, 10}, o.sample_step);
  visit(Field{"samples", "", "samples of a trajectory at most", 1, 1000}, o.samples);
}

/// One pair of velocities and what would come of it: a control period under it, then braking to a stop.
struct MotionCandidate {
  Command command;
  Pose2 end;                 ///< standing, in the frame of the map
  double distance = 0;       ///< from there to the subgoal [m]
  double heading_error = 0;  ///< from facing the subgoal there [rad], >= 0
  int samples = 1;           ///< of the trajectory
  int hard = 0;              ///< of these, nearer to a point than the hard margin
  int soft = 0;              ///< nearer than the soft margin
  bool near = false;         ///< the robot is near a point now
};

/// What a candidate costs, term by term [m].
struct MotionCost {
  double distance = 0;  ///< left to the subgoal
  double heading = 0;   ///< not facing it
  double hard = 0;      ///< too near
  double soft = 0;      ///< in the slow zone
  double speed = 0;     ///< fast there
};

/// An objective of one's own: the candidate with the least value is taken.
using OwnObjective = std::function<double(const MotionCandidate&)>;

/// What the controller needs to know of the cycle: all in the frame of the map.
struct MotionTask {
  Prediction now;      ///< velocities and period; its pose is that of the odometry
  double heading = 0;  ///< of the robot
  Vec2 subgoal{0, 0};
  double clearance = 0;  ///< from the hull to the nearest point now [m]
  const PolarLayout& layout;
  const ObstructedUnits& hard;
  const ObstructedUnits& soft;
};

/// Motion control [LM99]: the best pair of velocities in the window that can be reached within one control period.
class MotionControl {
 public:
  MotionControl(const Body& body, const MotionControlOptions& options, OwnObjective own = {});
  Command choose(const MotionTask& task);
  void reset() { best_ = {}; }
  /// The candidate chosen last.
  const MotionCandidate& chosen() const { return best_; }
  /// How far trajectories from here can lead [m].
  double reach(const Prediction& now) const;
  MotionCost cost(const MotionCandidate& candidate) const;
  /// The objective as the documentation has it.
  double objective(const MotionCandidate& candidate) const;

 private:
  /// A turning rate of the window, with the shapes of its two arcs for unit length.
  struct Turn {
    double w, driven, braked;  ///< turning in the period and while braking [rad]
    Vec2 drive, brake;
    double heading;  ///< in the end
  };
  struct Speed {
    double v, driven, braked;  ///< ways [m]
  };
  struct Open {
    double bound;  ///< the cost is at least this
    int index;
  };
  /// The first of so many equal parts of an arc of length 1, and how the next ones are turned.
  struct Stride {
    Vec2 chord;
    SinCos turn;
    bool known = false;
  };
  void make_window(const MotionTask& task);
  const Stride& stride(std::size_t turn, bool braking, int count, double heading, double turned);
  MotionCandidate candidate(const MotionTask& task, int index) const;
  void aim(const MotionTask& task, MotionCandidate& candidate) const;
  double bound(const MotionTask& task, const MotionCandidate& candidate) const;
  double heading_cost(const MotionCandidate& candidate) const;
  double hard_cost(const MotionCandidate& candidate) const;
  double soft_cost(const MotionCandidate& candidate) const;
  double speed_cost(const MotionCandidate& candidate) const;
  double free_cost(const MotionCandidate& candidate) const;
  double obstacle_cost(const MotionCandidate& candidate) const;
  void look(const MotionTask& task, int index, MotionCandidate& candidate, double free, double most);
  bool sample(const MotionTask& task, const Vec2& at, MotionCandidate& candidate) const;

  Body body_;
  MotionControlOptions options_;
  OwnObjective own_;
  std::vector<Speed> speeds_;
  std::vector<Turn> turns_;
  std::vector<Stride> strides_;  ///< by turn, arc and number of parts
  std::vector<Open> open_;
  MotionCandidate best_;
};

}  // namespace meander
