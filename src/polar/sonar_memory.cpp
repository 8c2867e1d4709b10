// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/sonar_memory.hpp"

#include <algorithm>
#include <cmath>

#include "polar/polar_layout.hpp"

namespace meander {
namespace {

constexpr double kNearMinimum = 0.015;  ///< readings so near to the least range count as saturated [m]
constexpr double kNearMaximum = 1e-3;   ///< readings so near to the largest range are no echo [m]
/// A beam contradicts a point that is nearer than its reading by more than this plus a share of the distance.
constexpr double kSlack = 0.25;
constexpr double kSlackShare = 0.05;

}  // namespace

SonarMemory::SonarMemory(const Platform& platform, const SonarMemoryOptions& options)
    : layout_(platform.sonar),
      body_radius_(platform.body.radius),
      options_(options),
      axis_cosine_(sin_cos(options.contradiction_angle).cos),
      ring_(static_cast<std::size_t>(options.scans)) {
  for (Scan& scan : ring_) scan.points.resize(static_cast<std::size_t>(layout_.count));
  beams_.reserve(static_cast<std::size_t>(layout_.count));
}

void SonarMemory::clear() {
  newest_ = held_ = 0;
  beams_.clear();
  for (Scan& scan : ring_) scan.count = 0;
}

std::span<const MemoryPoint> SonarMemory::scan(int age) const {
  const auto size = static_cast<int>(ring_.size());
  const Scan& scan = ring_[static_cast<std::size_t>((newest_ - age + size) % size)];
  return {scan.points.data(), scan.count};
}

void SonarMemory::remember(const Readings& readings) {
  aim(readings);
  if (options_.contradictions > 0) contradict();
  newest_ = (newest_ + 1) % static_cast<int>(ring_.size());
  held_ = std::min(held_ + 1, static_cast<int>(ring_.size()));
  take_points(std::min(options_.range_max, readings.sonar_max));
}

void SonarMemory::aim(const Readings& readings) {
  beams_.clear();
  const std::size_t count = std::min(readings.sonar.size(), readings.sonar_pose.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Pose2& pose = readings.sonar_pose[i];
    const double bearing = pose.heading + layout_.first + 2 * kPi * static_cast<double>(i) / static_cast<double>(count);
    const SinCos t = sin_cos(bearing);
    const Vec2 axis(t.cos, t.sin);
    beams_.push_back({pose.position() + layout_.radius * axis, axis, readings.sonar[i]});
  }
}

inline bool SonarMemory::passes_through(const Beam& beam, const Vec2& point) const {
  const Vec2 way = point - beam.from;
  const double along = way.dot(beam.axis);
  if (along <= 0) return false;
  const double square = way.squaredNorm();
  if (along * along < axis_cosine_ * axis_cosine_ * square) return false;
  const double distance = std::sqrt(square);
  return distance < beam.reading - kSlack - kSlackShare * distance;
}

/// Only the beams whose axes are nearest can go through a point: bearings from the robot find them.
void SonarMemory::contradict() {
  if (beams_.empty()) return;
  const Beam& first = beams_.front();
  const Vec2 centre = first.from - layout_.radius * first.axis;
  const auto count = static_cast<int>(beams_.size());
  const double zero = coarse_angle(first.axis.y(), first.axis.x());
  const int beside = 1 + static_cast<int>(options_.contradiction_angle * count / (2 * kPi));
  for (Scan& scan : ring_)
    for (std::size_t k = 0; k < scan.count; ++k) {
      MemoryPoint& point = scan.points[k];
      const Vec2 way = point.position - centre;
      const double turns = (coarse_angle(way.y(), way.x()) - zero) / (2 * kPi);
      int i = floor_of(turns * count + 0.5) - beside;
      while (i < 0) i += count;
      while (i >= count) i -= count;
      for (int tried = 0; tried <= 2 * beside; ++tried, i = i + 1 == count ? 0 : i + 1)
        if (passes_through(beams_[static_cast<std::size_t>(i)], point.position)) {
          ++point.contradicted;
          break;
        }
      if (point.contradicted >= options_.contradictions) point = scan.points[--scan.count], --k;
    }
}

/// Of beams that read less than `silence`.
void SonarMemory::take_points(double silence) {
  Scan& scan = ring_[static_cast<std::size_t>(newest_)];
  scan.count = 0;
  if (scan.points.size() < beams_.size()) scan.points.resize(beams_.size());
  const double off_hull = body_radius_ + options_.saturated_gap - layout_.radius;
  for (const Beam& beam : beams_) {
    if (!(beam.reading < silence - kNearMaximum)) continue;
    const double range = beam.reading <= options_.range_min + kNearMinimum ? off_hull : beam.reading;
    scan.points[scan.count++] = {beam.from + range * beam.axis, 0};
  }
}

}  // namespace meander
