// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "render/draw_run.hpp"
#include "render/draw_scan.hpp"
#include "render/theme.hpp"
#include "world/world.hpp"

namespace meander {

/// Where everything is in one moment.
struct Moment {
  double time = 0;                          ///< [s]
  std::vector<Pose2> poses;                 ///< one per robot
  std::vector<Pose2> scanned_from;          ///< where each robot was at its last scan
  std::vector<std::vector<double>> ranges;  ///< that scan [m]
  std::vector<Disc> movers;
};

/// The moment `share` of the way from one to another in which the same things move. Scans are those of `from`.
Moment between(const Moment& from, const Moment& to, double share);

/// The picture of a drive that goes on. What stays is drawn once, what moves for each frame.
class LivePicture {
 public:
  LivePicture(const World& world, std::vector<RobotLook> robots);

  /// Takes over edits of the world.
  void follow(const World& world);
  /// The subgoals of a robot.
  void set_goals(std::size_t robot, std::vector<TrackGoal> goals);
  /// The robot was there: its way grows.
  void pass(std::size_t robot, const Pose2& pose, bool touching);
  /// Valid until the next call.
  const DrawList& at(const Moment& moment);

  /// Draws on the ground, below the robots, in each picture anew.
  std::function<void(DrawList&, const Theme&)> on_ground;

 private:
  struct Way {
    std::vector<Pose2> poses;  ///< apart by what can be seen, each place once; not finite: a gap
    std::optional<Pose2> last;
    std::set<std::pair<long, long>> places;
    std::vector<Vec2> contacts;
    std::vector<TrackGoal> goals;
    bool known = false;  ///< `last` was at a known place
    bool touching = false;
  };

  void draw_ground(const World& world);
  void extend(Way& way, const Pose2& pose) const;

  std::vector<RobotLook> robots_;
  std::vector<Way> ways_;
  DrawList list_;
  std::size_t ground_ = 0;  ///< items that stay
  std::uint64_t seen_ = 0;  ///< edits of the world that are drawn
};

}  // namespace meander
