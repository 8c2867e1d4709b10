// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>

#include "geometry/shapes.hpp"

namespace meander {

/// Notices that the robot gets no nearer to its target.
class TrapWatch {
 public:
  /// Trapped after `patience` seconds without `progress` metres.
  TrapWatch(double patience, double progress) : patience_(patience), progress_(progress) {}

  /// Once per cycle: trapped now? The watch then begins anew.
  bool update(double time, const Vec2& at, const Vec2& target);
  /// Forgets how near the robot has been lately.
  void begin(double time);
  double distance() const { return distance_; }
  double nearest() const { return nearest_ever_; }   ///< that the robot has been to this target [m]
  bool new_nearest() const { return new_nearest_; }  ///< nearer by the progress in this cycle, or another target
  int traps() const { return traps_; }               ///< noticed so far
  void reset() { *this = TrapWatch(patience_, progress_); }

 private:
  double patience_;
  double progress_;
  std::optional<Vec2> target_;
  double distance_ = 0;
  double nearest_ = 0;       ///< since the last new beginning [m]
  double nearest_ever_ = 0;  ///< to this target [m]
  bool new_nearest_ = false;
  double since_ = 0;
  int traps_ = 0;
};

}  // namespace meander
