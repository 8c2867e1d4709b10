// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/ray.hpp"

#include "base/error.hpp"
#include "geometry/nearest_hit.hpp"

namespace meander {

std::optional<RayHit> cast_ray(const Scene& scene, const Vec2& origin, const Vec2& direction, double max_range,
                               std::uint32_t self) {
  const std::optional<RayHit> standing = scene.walls().cast(origin, direction, max_range);
  NearestHit moving(origin, direction, standing ? standing->range : max_range);
  for (const Pole& pole : scene.moving)
    if (pole.owner != self) moving.meet_pole(pole.disc, pole.owner);
  const std::optional<RayHit> hit = moving.hit();
  return hit && !(standing && hit->range == standing->range) ? hit : standing;
}

void cast_fan(const Scene& scene, const Pose2& pose_world, std::span<const double> bearings, double max_range,
              std::uint32_t self, std::span<double> ranges) {
  if (bearings.size() != ranges.size())
    fail("cast_fan: as many ranges as bearings expected, got {} and {}", ranges.size(), bearings.size());
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const SinCos t = sin_cos(pose_world.heading + bearings[i]);
    const auto hit = cast_ray(scene, pose_world.position(), {t.cos, t.sin}, max_range, self);
    ranges[i] = hit ? hit->range : max_range;
  }
}

}  // namespace meander
