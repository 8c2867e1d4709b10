// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/point_mapper.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// Points nearer to where the robot is than this share of its radius are errors.
constexpr double kErroneous = 0.9;
/// A point within the body as predicted is kept, this far off the hull [m]: without it the robot would drive into what
/// it is about to touch.
constexpr double kPushedOut = 0.005;
constexpr int kMostSquares = 4096;

}  // namespace

PointMapper::PointMapper(double body_radius, double scope, double merge, std::size_t most)
    : radius_(body_radius), scope_(scope), merge_(merge) {
  points_.reserve(most);
  if (!(merge > 0)) return;
  merge_ = std::max(merge, 2 * scope / (kMostSquares - 2));
  side_ = static_cast<int>(2 * scope / merge_) + 2;
  raster_.resize((static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 63) / 64);
}

void PointMapper::map(const SonarMemory& memory, const Pose2& odometry_from_map, const Vec2& robot_now) {
  begin(odometry_from_map, robot_now);
  for (int age = 0; age < memory.scans(); ++age)
    for (const MemoryPoint& remembered : memory.scan(age)) add(remembered.position, age);
}

void PointMapper::map(std::span<const Vec2> points, const Pose2& odometry_from_map, const Vec2& robot_now) {
  begin(odometry_from_map, robot_now);
  for (const Vec2& point : points) add(point, 0);
}

void PointMapper::begin(const Pose2& odometry_from_map, const Vec2& robot_now) {
  points_.clear();
  std::fill(raster_.begin(), raster_.end(), std::uint64_t{0});
  origin_ = odometry_from_map.position();
  x_axis_ = odometry_from_map.direction();
  y_axis_ = left_of(x_axis_);
  robot_now_ = robot_now;
  nearest_square_ = scope_ * scope_;
}

void PointMapper::add(const Vec2& position, int age) {
  const Vec2 way = position - origin_;
  Vec2 p(way.dot(x_axis_), way.dot(y_axis_));
  double square = p.squaredNorm();
  if (!(square <= scope_ * scope_)) return;
  if ((position - robot_now_).squaredNorm() < kErroneous * kErroneous * radius_ * radius_) return;
  if (square < radius_ * radius_) {
    if (square < 1e-12) return;
    p *= (radius_ + kPushedOut) / std::sqrt(square);
    square = p.squaredNorm();
    if (!(square <= scope_ * scope_)) return;  // the raster ends there
  }
  nearest_square_ = std::min(nearest_square_, square);
  if (new_place(p)) points_.push_back({p, age});
}

/// The first point in each square of the raster: the newest, as they come by age.
bool PointMapper::new_place(const Vec2& p) {
  if (raster_.empty()) return true;
  const auto x = static_cast<std::size_t>((p.x() + scope_) / merge_),
             y = static_cast<std::size_t>((p.y() + scope_) / merge_);
  const std::size_t square = y * static_cast<std::size_t>(side_) + x;
  const std::uint64_t bit = std::uint64_t{1} << (square & 63);
  if (raster_[square >> 6] & bit) return false;
  raster_[square >> 6] |= bit;
  return true;
}

}  // namespace meander
