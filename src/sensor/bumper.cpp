// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/bumper.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace meander {
namespace {

/// The ring of bumpers while it is read. Positions are relative to the body's centre, bearings to its heading.
class BumperRing {
 public:
  BumperRing(const RingLayout& layout, double reach, const Pose2& pose_world, std::span<std::uint8_t> pressed)
      : layout_(layout), reach_(layout.radius + reach), pose_(pose_world), pressed_(pressed) {}

  double reach() const { return reach_; }

  /// The part of the wall within reach, seen from the centre, spans the bearings between its two ends.
  void touch(const Wall& wall) {
    const Vec2 a = wall.a - pose_.position(), d = wall.b - wall.a;
    const double middle = -a.dot(d) / d.squaredNorm();
    const double half_squared = (reach_ * reach_ - (a + middle * d).squaredNorm()) / d.squaredNorm();
    if (half_squared < 0) return;
    const double half = std::sqrt(half_squared), t0 = std::max(0.0, middle - half), t1 = std::min(1.0, middle + half);
    if (t0 > t1) return;
    const double from = bearing(a + t0 * d);
    press(from, angle_between(from, bearing(a + t1 * d)));
  }

  /// The part of the disc within reach: bounded by its tangents, or where its rim crosses the circle of reach.
  void touch(const Disc& disc) {
    const Vec2 c = disc.center - pose_.position();
    const double distance = c.norm(), r = disc.radius;
    if (distance > reach_ + r) return;
    if (distance <= r) return press(0, 2 * kPi);
    const double tangent_squared = (distance - r) * (distance + r);
    const double half = tangent_squared <= reach_ * reach_
                            ? angle_of(r, std::sqrt(tangent_squared))
                            : arc_cosine((reach_ * reach_ + tangent_squared) / (2 * reach_ * distance));
    press(bearing(c) - half, 2 * half);
  }

 private:
  static double arc_cosine(double cosine) { return angle_of(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine); }

  double bearing(const Vec2& p) const { return angle_of(p.y(), p.x()) - pose_.heading - layout_.first; }

  /// Presses all bumpers between bearing `from` and `from + sweep`, ends included.
  void press(double from, double sweep) {
    const double share = 2 * kPi / layout_.count;
    const double low = std::min(from, from + sweep) / share + 0.5, high = low + std::abs(sweep) / share;
    const auto first = static_cast<long>(std::floor(low));
    const long last = std::min(static_cast<long>(std::floor(high)), first + layout_.count - 1);
    for (long i = first; i <= last; ++i) {
      const long wrapped = (i % layout_.count + layout_.count) % layout_.count;
      pressed_[static_cast<std::size_t>(wrapped)] = 1;
    }
  }

  const RingLayout& layout_;
  double reach_;  ///< from the centre
  const Pose2& pose_;
  std::span<std::uint8_t> pressed_;
};

}  // namespace

void read_bumpers(const Scene& scene, const RingLayout& layout, double reach, const Pose2& pose_world,
                  std::uint32_t self, std::span<std::uint8_t> pressed) {
  if (pressed.size() != static_cast<std::size_t>(layout.count))
    fail("read_bumpers: room for {} bumpers expected, got {}", layout.count, pressed.size());
  std::fill(pressed.begin(), pressed.end(), 0);
  if (layout.count == 0) return;
  BumperRing ring(layout, reach, pose_world, pressed);
  for (const Pole& pole : scene.moving)
    if (pole.owner != self) ring.touch(pole.disc);
  if (scene.walls().distance(pose_world.position(), ring.reach() + kTouch) > ring.reach()) return;
  scene.walls().around(
      pose_world.position(), ring.reach(), [&](const Wall& wall) { ring.touch(wall); },
      [&](const Disc& disc) { ring.touch(disc); });
}

}  // namespace meander
