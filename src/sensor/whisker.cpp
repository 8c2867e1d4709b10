// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/whisker.hpp"

#include "sensor/ray.hpp"

namespace meander {

WhiskerRing::WhiskerRing(const RingLayout& layout, const WhiskerOptions& options, std::uint64_t seed)
    : layout_(layout), options_(options), stream_(seed, "whisker") {
  validate(options, "whisker.");
}

void WhiskerRing::read(const Scene& scene, const Pose2& pose_world, std::uint32_t self, std::span<std::uint8_t> bent) {
  const double tip = layout_.radius + options_.reach;
  const double share = 2 * kPi / layout_.count;
  for (std::size_t i = 0; i < bent.size(); ++i) {
    const SinCos along = sin_cos(wrap_angle(pose_world.heading + layout_.first + static_cast<double>(i) * share));
    const bool touches = cast_ray(scene, pose_world.position(), {along.cos, along.sin}, tip, self).has_value();
    bent[i] = stream_.chance(touches ? 1 - options_.miss : options_.false_alarm);
  }
}

}  // namespace meander
