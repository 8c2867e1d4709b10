// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/sweep.hpp"

#include <algorithm>
#include <cmath>

namespace meander {

SweepMaker::SweepMaker(const RingLayout& ring, double range_max)
    : ring_(ring), range_max_(range_max), ranges_(static_cast<std::size_t>(ring.count)) {}

SonarSweep SweepMaker::sweep(const Readings& readings, const Pose2& now) {
  if (readings.sonar.size() != ranges_.size() || readings.sonar_pose.size() != ranges_.size())
    fail("readings of {} sonars with their poses expected, got {} with {}", ranges_.size(), readings.sonar.size(),
         readings.sonar_pose.size());
  const double pitch = 2 * kPi / ring_.count;
  const auto count = static_cast<int>(ranges_.size());
  for (int i = 0; i < count; ++i) {
    const double bearing = ring_.first + pitch * i;
    const Pose2& fired = readings.sonar_pose[static_cast<std::size_t>(i)];
    // Turned by half a pitch and more since: the neighbour's axis pointed there.
    const double turned = angle_between(fired.heading, now.heading) / pitch;
    const int beside = std::isfinite(turned) ? static_cast<int>(std::lround(turned)) : 0;
    const int taken = ((i + beside) % count + count) % count;
    ranges_[static_cast<std::size_t>(i)] = seen_from(readings, static_cast<std::size_t>(taken), bearing, now);
  }
  return {ranges_, silence(readings)};
}

double SweepMaker::seen_from(const Readings& readings, std::size_t index, double bearing, const Pose2& now) const {
  const double range = readings.sonar[index], silence = this->silence(readings);
  if (!(range < silence)) return silence;
  const SinCos axis = sin_cos(wrap_angle(now.heading + bearing));
  const Vec2 driven = now.position() - readings.sonar_pose[index].position();
  const double since = range - driven.dot(Vec2(axis.cos, axis.sin));
  return std::isfinite(since) ? std::clamp(since, 0.0, silence) : silence;
}

}  // namespace meander
