// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <array>
#include <span>
#include <vector>

#include "robot/observation.hpp"
#include "robot/platform.hpp"

namespace meander {

/// Throws ArgumentError at a platform that this navigator cannot drive: it is no good or has no sonars.
void need_sonars(const char* navigator, const Platform& platform);

/// What one sonar tells about where something stands, in the robot's present frame.
struct Echo {
  Vec2 axis{0, 0};               ///< on the axis of the cone
  Vec2 point{0, 0};              ///< the likeliest place
  std::array<Vec2, 3> places{};  ///< places it may be at, within the cone
  double gap = 0;                ///< from the hull to `point` [m], >= 0
  bool nearest = false;          ///< neither neighbour is nearer: the nearest point of some surface
};

/// How readings are read.
struct EchoRule {
  double range_min = 0.152;  ///< what reads so near may touch the hull [m]
  double range_max = 3;      ///< farther readings are left out [m]
  double half_cone = 0.2181661564992912;
};

/// The echoes of one cycle's readings. Walls answer from the side of the cone on which the neighbour is nearer; where
/// both neighbours are farther, the three ranges tell the bearing (vertex of the parabola through them).
void read_echoes(const Observation& observation, const Platform& platform, const EchoRule& rule,
                 std::vector<Echo>& echoes);

}  // namespace meander
