// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/near_points.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

constexpr double kInside = 0.9;     ///< share of the body's radius within which a point must be wrong
constexpr double kContact = 0.001;  ///< points within the radius count as touched from so far outside [m]
constexpr double kStraight = 1e-6;  ///< smaller curvatures are none [1/m]

/// Straight on: the first crossing of y = p.y with the circle around the point.
double free_line(const Vec2& p, double radius, double most) {
  if (p.x() <= 0 || std::abs(p.y()) >= radius) return most;
  return std::clamp(p.x() - std::sqrt(radius * radius - p.y() * p.y()), 0.0, most);
}

/// On a circle around (0, 1/curvature): the law of cosines gives the angle at which the disc meets the point.
double free_circle(const Vec2& p, double curvature, double radius, double most) {
  const double turning = 1 / curvature, size = std::abs(turning);
  const Vec2 from_centre = p - Vec2(0, turning);
  const double reach = from_centre.norm();
  if (std::abs(reach - size) >= radius || reach == 0) return most;
  const double side = curvature > 0 ? 1 : -1;
  // The way round the circle to the point's bearing, 0 where the robot is, against its sense of turning.
  double ahead = angle_of(from_centre.x(), -side * from_centre.y());
  if (ahead < 0) ahead += 2 * kPi;
  const double cosine = std::clamp((size * size + reach * reach - radius * radius) / (2 * size * reach), -1.0, 1.0);
  const double before = angle_of(std::sqrt(1 - cosine * cosine), cosine);
  if (ahead < before) return 0;  // within the radius already, and ahead
  // A point that is left behind comes round again only after the circle.
  return std::min(most, (ahead - before) * size);
}

}  // namespace

void points_near(const SonarMemory& memory, const Pose2& pose, double body_radius, double reach,
                 std::vector<Vec2>& points) {
  points.clear();
  const Pose2 robot_from_odometry = inverse(pose);
  const double least = kInside * body_radius;
  for (int age = 0; age < memory.scans(); ++age)
    for (const MemoryPoint& remembered : memory.scan(age)) {
      const Vec2 point = robot_from_odometry * remembered.position;
      const double square = point.squaredNorm();
      if (square <= reach * reach && square >= least * least) points.push_back(point);
    }
}

double free_arc(const std::vector<Vec2>& points, double curvature, double radius, double most) {
  double free = most;
  for (const Vec2& point : points) {
    const double distance = point.norm();
    if (distance > radius + free) continue;
    const double touch = std::min(radius, distance - kContact);
    free = std::min(free, std::abs(curvature) < kStraight ? free_line(point, touch, free)
                                                          : free_circle(point, curvature, touch, free));
  }
  return free;
}

}  // namespace meander
