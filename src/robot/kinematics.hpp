// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "robot/observation.hpp"
#include "robot/platform.hpp"

namespace meander {

/// The pose after `dt` seconds with constant velocities in the body's own frame: v forward, vy to the left, w turning.
/// Exact.
Pose2 twist(const Pose2& pose, double v, double vy, double w, double dt);
/// The same for a unicycle: an arc.
inline Pose2 arc(const Pose2& pose, double v, double w, double dt) { return twist(pose, v, 0, w, dt); }

/// `value` moved towards `target` by at most `most`.
double ramp(double value, double target, double most);

/// A velocity that runs from its present value to its target at a limited rate.
struct Ramped {
  double end;   ///< value after dt
  double mean;  ///< average over dt, exact also when the target is met on the way
};
Ramped ramped(double value, double target, double rate, double dt);

/// The same in the plane: straight from the one velocity to the other, so that it is never faster than both.
struct RampedPlane {
  Vec2 end, mean;
};
RampedPlane ramped(const Vec2& value, const Vec2& target, double rate, double dt);

/// The command within the body's limits; NaN and infinity become 0. Unicycles have no sideways speed; omnidirectional
/// bodies keep the direction and are no faster than v_max in any.
Command limited(const Command& command, const Body& body);

/// Pose between two poses of a short motion: position on the chord, heading on the shorter way; share in [0, 1].
Pose2 between(const Pose2& from, const Pose2& to, double share);

}  // namespace meander
