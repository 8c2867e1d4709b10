// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <span>

#include "sensor/scene.hpp"

namespace meander {

/// First thing on the ray, exactly: walls, poles and the moving discs of this instant, but for the disc of owner `self`
/// (the sensor's own robot; any unused number for none). `direction` is a unit vector.
std::optional<RayHit> cast_ray(const Scene& scene, const Vec2& origin, const Vec2& direction, double max_range,
                               std::uint32_t self);

/// A fan of rays from the pose's position, at bearings [rad] relative to its heading: `ranges[i]` receives the range
/// [m] at `bearings[i]`, `max_range` where nothing is hit.
void cast_fan(const Scene& scene, const Pose2& pose_world, std::span<const double> bearings, double max_range,
              std::uint32_t self, std::span<double> ranges);

}  // namespace meander
