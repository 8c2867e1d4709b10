// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/light.hpp"

#include <cmath>

#include "base/elementary.hpp"
#include "sensor/ray.hpp"

namespace meander {

LightRing::LightRing(const RingLayout& layout, const LightSensorOptions& options, std::uint64_t seed)
    : layout_(layout), options_(options), full_scale_(logarithm(1 + options.contrast)), stream_(seed, "light") {
  validate(options, "light.");
}

double LightRing::brightness(const Scene& scene, const Vec2& place, double bearing, std::uint32_t self) const {
  double sum = 0;
  for (const Lamp& lamp : scene.lamps()) {
    const Vec2 way = lamp.position - place;
    const double distance = way.norm();
    if (distance > 0 && cast_ray(scene, place, way / distance, distance, self)) continue;  // in the shadow
    const double off = distance > 0 ? angle_between(bearing, angle_of(way.y(), way.x())) / options_.lobe : 0;
    sum += lamp.strength / (1 + distance * distance) * exponential(-0.5 * off * off);
  }
  return sum;
}

void LightRing::read(const Scene& scene, const Pose2& pose_world, std::uint32_t self, std::span<double> readings) {
  const double share = 2 * kPi / layout_.count;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const double bearing = wrap_angle(pose_world.heading + layout_.first + static_cast<double>(i) * share);
    const SinCos along = sin_cos(bearing);
    const Vec2 place = pose_world.position() + layout_.radius * Vec2(along.cos, along.sin);
    const double seen = brightness(scene, place, bearing, self);
    readings[i] = logarithm(1 + options_.contrast * seen) / full_scale_ * (1 + options_.noise * stream_.normal());
  }
}

}  // namespace meander
