// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <span>

#include "robot/platform.hpp"
#include "sensor/scene.hpp"

namespace meander {

/// Which bumpers of the ring are pressed: a bumper covers its share of the circle; pressed where the body is within
/// `reach` [m] of a surface. `pressed` has layout.count entries.
void read_bumpers(const Scene& scene, const RingLayout& layout, double reach, const Pose2& pose_world,
                  std::uint32_t self, std::span<std::uint8_t> pressed);

}  // namespace meander
