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

/// Where on its circle around (0, 1/curvature) the disc meets the first thing. Bearings from the circle's centre count
/// from the robot in its sense of turning, and are compared by their cosine and sine: angles are dear.
class CircleWay {
 public:
  explicit CircleWay(double curvature) : size_(1 / std::abs(curvature)), side_(curvature > 0 ? 1 : -1) {}

  /// The law of cosines gives the bearing at which the disc meets the point.
  void meet(const Vec2& p, double touch) {
    const double ahead_sin = p.x(), ahead_cos = size_ - side_ * p.y();
    const double square = ahead_sin * ahead_sin + ahead_cos * ahead_cos;
    const double reach = std::sqrt(square);
    if (std::abs(reach - size_) >= touch || reach == 0) return;
    const double cosine = std::clamp((size_ * size_ + square - touch * touch) / (2 * size_ * reach), -1.0, 1.0);
    const double sine = std::sqrt(1 - cosine * cosine);
    const SinCos met{(ahead_sin * cosine - ahead_cos * sine) / reach, (ahead_cos * cosine + ahead_sin * sine) / reach};
    if (!met_ || before(met, first_)) first_ = met, met_ = true;
  }

  /// A point that is left behind comes round again only after the circle.
  double way(double most) const {
    if (!met_) return most;
    const double angle = angle_of(first_.sin, first_.cos);
    return std::min(most, (angle < 0 ? angle + 2 * kPi : angle) * size_);
  }
  /// No place of the way is farther from the robot than this.
  double chord(double most) const {
    const double across = std::min(most, 2 * size_);
    return met_ && first_.sin >= 0 ? std::min(across, size_ * std::sqrt(2 * (1 - first_.cos))) : across;
  }

 private:
  static bool before(const SinCos& a, const SinCos& b) {
    if ((a.sin >= 0) != (b.sin >= 0)) return a.sin >= 0;
    return a.sin >= 0 ? a.cos > b.cos : a.cos < b.cos;
  }

  double size_, side_;
  SinCos first_{0, 1};
  bool met_ = false;
};

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

ConeEnds::ConeEnds(const Platform& platform, double range_min, double half_cone)
    : platform_(platform), rule_{.range_min = range_min, .half_cone = half_cone} {
  echoes_.reserve(static_cast<std::size_t>(platform.sonar.count));
}

void ConeEnds::add(const Observation& observation, double reach, std::vector<Vec2>& points) {
  rule_.range_max = reach;
  read_echoes(observation, platform_, rule_, echoes_);
  const double least = kInside * platform_.body.radius;
  for (const Echo& echo : echoes_)
    for (const Vec2& place : echo.places) {
      const double square = place.squaredNorm();
      if (square <= reach * reach && square >= least * least) points.push_back(place);
    }
}

double free_arc(const std::vector<Vec2>& points, double curvature, double radius, double most) {
  const double bend = std::abs(curvature), side = curvature < 0 ? -1 : 1;
  const bool straight = bend < kStraight;
  CircleWay circle(straight ? 1 : curvature);
  double free = most, reach = straight ? most : circle.chord(most);
  for (const Vec2& point : points) {
    const double square = point.squaredNorm();
    if (square > (radius + reach) * (radius + reach)) continue;
    // Does the disc pass beside the point? Compares the distance from the circle's centre, without a root.
    const double off = (square - radius * radius) * bend - 2 * side * point.y();
    if (off >= 2 * radius || (off <= -2 * radius && bend * radius < 1)) continue;
    const double touch = std::min(radius, std::sqrt(square) - kContact);
    if (straight) {
      reach = free = std::min(free, free_line(point, touch, free));
    } else {
      circle.meet(point, touch);
      reach = circle.chord(most);
    }
  }
  return straight ? free : circle.way(most);
}

}  // namespace meander
