// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "robot/observation.hpp"
#include "robot/platform.hpp"

namespace meander {

/// The pose after driving the exact arc of a unicycle with constant v and w for `dt` seconds.
Pose2 arc(const Pose2& pose, double v, double w, double dt);

/// `value` moved towards `target` by at most `most`.
double ramp(double value, double target, double most);

/// The command within the body's limits; NaN and infinity become 0.
Command limited(const Command& command, const Body& body);

}  // namespace meander
