// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/unmapped_obstacles.hpp"

#include <algorithm>
#include <utility>

namespace meander {

UnmappedObstacles::UnmappedObstacles(const Platform& platform, std::shared_ptr<const PlanningMap> map, double tolerance)
    : platform_(platform), map_(std::move(map)), tolerance_(tolerance), heard_(platform_) {}

const std::vector<Vec2>& UnmappedObstacles::points() {
  const ConfigurationSpace& space = heard_.space();
  if (clearance_ && map_version_ == map_->version && heard_version_ == space.version() && frames_ == heard_.frames())
    return points_;
  if (!clearance_ || map_version_ != map_->version) clearance_.emplace(map_->solid);
  map_version_ = map_->version;
  heard_version_ = space.version();
  frames_ = heard_.frames();
  points_.clear();
  const GridFrame& frame = map_->solid.frame;
  const double cells = tolerance_ / frame.resolution;
  for (int y = 0; y < space.height(); ++y)
    for (int x = 0; x < space.width(); ++x) {
      if (space.known({x, y}) != Known::wall) continue;
      const Vec2 center = space.frame().center({x, y}), in_cells = frame.in_cells(center);
      if (clearance_->of(in_cells, in_cells, cells) >= cells) points_.push_back(center);
    }
  return points_;
}

bool UnmappedObstacles::beside(const Vec2& from, const Vec2& to, double distance) const {
  const Vec2 way = to - from;
  const double square = way.squaredNorm();
  return std::any_of(points_.begin(), points_.end(), [&](const Vec2& point) {
    const double share = square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0.0;
    return (from + share * way - point).squaredNorm() < distance * distance;
  });
}

void UnmappedObstacles::forget() {
  heard_ = SonarOccupancy(platform_);
  points_.clear();
  frames_ = 0;
  clearance_.reset();
}

}  // namespace meander
