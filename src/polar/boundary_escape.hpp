// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/fields.hpp"
#include "polar/boundary_walk.hpp"
#include "polar/sonar_memory.hpp"

namespace meander {

struct BoundaryEscapeOptions {
  int directions = 72;
  double reach = 1.9;
  double clearance = 0.03;
  double look = 0.4;
  double leave = 0.16;
  double loop = 0.5;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, BoundaryEscapeOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"directions", "", "in which the free way is looked at", 8, 720}, o.directions);
  visit(Field{"reach", "m", "how far the memory is trusted", 0.1, 100}, o.reach);
  visit(Field{"clearance", "m", "hull distance at which walls are passed", 0, 10}, o.clearance);
  visit(Field{"look", "m", "free way that makes a direction good enough along a wall", 0.01, 100}, o.look);
  visit(Field{"leave", "m", "over when a place so much nearer to the target than ever before is in reach", 0, 100},
        o.leave);
  visit(Field{"loop", "m", "coming so near to where it has been means that there is no way on this side", 0, 100},
        o.loop);
}

/// Out of a trap of any size: along the boundary of what is in the way, by a temporary target ahead of the robot.
class BoundaryEscape {
 public:
  BoundaryEscape(const Platform& platform, const BoundaryEscapeOptions& options);

  /// `left`: goes left, the wall on the right. `nearest`: how near to the target the robot ever was [m]. `least`: the
  /// way before it can be over [m].
  void begin(double time, const Pose2& pose, const Vec2& target, double nearest, bool left, double least);
  void stop() { walk_.reset(); }
  bool active() const { return walk_.has_value(); }

  enum class State { walking, over, round, stuck };
  /// Once per cycle while active. Over or in vain: no longer active.
  State update(double time, const Pose2& pose, const Vec2& target, const SonarMemory& memory, double patience);
  /// Where to go instead of the target while walking, in the odometry frame.
  const Vec2& temporary() const { return temporary_; }

 private:
  State judge(double time, const Pose2& pose, double patience);
  bool passed_before(const Pose2& pose) const;
  void remember(const Pose2& pose);
  void choose(const Pose2& pose);

  /// A place along the wall and the heading there, after so long a way [m].
  struct Passed {
    Pose2 pose;
    double driven;
  };

  double body_radius_;
  BoundaryEscapeOptions options_;
  FreeWays ways_;
  std::vector<Vec2> points_;  ///< near the robot, in its frame
  std::optional<BoundaryWalk> walk_;
  Vec2 temporary_{0, 0};
  Vec2 place_{0, 0};  ///< where it was when it last got anywhere
  double since_ = 0;
  double least_ = 0;
  double new_until_ = 0;  ///< way after which only places came that it had passed before [m]
  std::vector<Passed> passed_;
};

}  // namespace meander
