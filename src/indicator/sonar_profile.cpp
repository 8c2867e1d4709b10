// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/sonar_profile.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace meander {
namespace {

constexpr double kWide = 1.25, kMargin = 0.2;  ///< open is more than so many clearances and so much [m]
constexpr double kProminent = 0.3;             ///< a dip that divides an interval is deeper than this [m]

}  // namespace

SonarProfile::SonarProfile(const Platform& platform, const SonarProfileOptions& options)
    : options_(options), ring_(platform.sonar), radius_(std::max(platform.body.radius - options.slim, 0.01)) {
  validate(options);
  if (options.most * options.directions < 2 * kPi)
    fail(
        "options 'profile.directions' and 'profile.most': intervals of at least one direction, {:g} rad, expected, got "
        "{} rad",
        2 * kPi / options.directions, options.most);
  const SinCos half = sin_cos(options.beam);
  tangent_ = half.sin / half.cos;
}

void SonarProfile::clear() {
  echoes_.clear();
  last_.reset();
  walked_ = 0;
}

/// Echoes count as points on the axes of their cones. What a later beam goes through is not there.
void SonarProfile::update(const Observation& observation) {
  const Vec2 here = observation.odometry.pose.position();
  walked_ += last_ ? (here - *last_).norm() : 0;
  last_ = here;
  while (!echoes_.empty() && walked_ - echoes_.front().walked > options_.memory) echoes_.pop_front();
  const Readings& readings = observation.readings;
  std::vector<Echo> heard;
  for (std::size_t i = 0; i < readings.sonar.size(); ++i) {
    const double bearing = ring_.first + 2 * kPi * static_cast<double>(i) / static_cast<double>(readings.sonar.size());
    const Pose2 robot = i < readings.sonar_pose.size() ? readings.sonar_pose[i] : observation.odometry.pose;
    const Vec2 axis = Pose2{0, 0, wrap_angle(robot.heading + bearing)}.direction();
    const Vec2 from = robot.position() + ring_.radius * axis;
    const double reading = readings.sonar[i];
    std::erase_if(echoes_, [&](const Echo& echo) {
      const Vec2 to = echo.at - from;
      const double along = to.dot(axis), across = std::abs(axis.x() * to.y() - axis.y() * to.x());
      return along > 0 && across < tangent_ * along && to.norm() < std::min(reading, options_.range) - options_.through;
    });
    if (reading < options_.range && reading < readings.sonar_max) heard.push_back({from + reading * axis, walked_});
  }
  echoes_.insert(echoes_.end(), heard.begin(), heard.end());
}

double SonarProfile::clearance(const Vec2& at) const {
  double least = options_.range;
  for (const Echo& echo : echoes_) least = std::min(least, (echo.at - at).norm());
  return least;
}

/// A disc along a straight line. An echo inside it stops only motion that leads nearer.
double SonarProfile::way_on(const Vec2& at, double direction) const {
  const SinCos way = sin_cos(direction);
  const Vec2 axis(way.cos, way.sin);
  double length = options_.range;
  for (const Echo& echo : echoes_) {
    const Vec2 to = echo.at - at;
    const double along = to.dot(axis), across = axis.x() * to.y() - axis.y() * to.x();
    if (along <= 0 || std::abs(across) >= radius_) continue;
    length = std::min(length, std::max(along - std::sqrt(radius_ * radius_ - across * across), 0.0));
  }
  return length;
}

void SonarProfile::look(const Vec2& at) {
  lengths_.resize(static_cast<std::size_t>(options_.directions));
  for (std::size_t i = 0; i < lengths_.size(); ++i)
    lengths_[i] = way_on(at, wrap_angle(2 * kPi * static_cast<double>(i) / options_.directions));
}

double SonarProfile::length(int direction) const {
  return lengths_[static_cast<std::size_t>((direction % options_.directions + options_.directions) %
                                           options_.directions)];
}

/// [DG] Figure 1: the intervals of directions in which the robot could drive on. Their middles, for the longest way
/// within an interval leads along one of its sides.
std::vector<SeenPort> SonarProfile::openings(const Vec2& at) {
  look(at);
  const double enough = std::max(options_.open, kWide * clearance(at) + kMargin);
  const int all = options_.directions;
  const auto open = [&](int i) { return length(i) >= enough; };
  int closed = 0;
  while (closed < all && open(closed)) ++closed;
  std::vector<Interval> pieces;
  if (closed == all) divide({0, all}, pieces);
  for (int i = closed + 1; i < closed + all;) {
    const int first = i;
    while (i < closed + all && open(i)) ++i;
    if (i > first) divide({first, i - first}, pieces);
    ++i;
  }
  std::vector<SeenPort> ports;
  const double step = 2 * kPi / all;
  for (const Interval& piece : pieces) {
    if (piece.count * step < options_.least) continue;
    const double direction = wrap_angle((piece.first + (piece.count - 1) / 2.0) * step);
    ports.push_back({direction, way_on(at, direction)});
  }
  return ports;
}

/// At its deepest dip where that stands out on both sides, else in the middle.
void SonarProfile::divide(const Interval& interval, std::vector<Interval>& pieces) {
  if (interval.count < 2 || interval.count * 2 * kPi / options_.directions <= options_.most) {
    pieces.push_back(interval);
    return;
  }
  int cut = interval.count / 2;
  double deepest = kProminent;
  rest_.assign(static_cast<std::size_t>(interval.count), 0);  // the longest way to the right of each direction
  for (int i = interval.count - 2; i >= 0; --i)
    rest_[static_cast<std::size_t>(i)] =
        std::max(rest_[static_cast<std::size_t>(i) + 1], length(interval.first + i + 1));
  double left = 0;
  for (int i = 1; i + 1 < interval.count; ++i) {
    left = std::max(left, length(interval.first + i - 1));
    const double depth = std::min(left, rest_[static_cast<std::size_t>(i)]) - length(interval.first + i);
    if (depth <= deepest) continue;
    deepest = depth;
    cut = i;
  }
  divide({interval.first, cut}, pieces);
  divide({interval.first + cut, interval.count - cut}, pieces);
}

}  // namespace meander
