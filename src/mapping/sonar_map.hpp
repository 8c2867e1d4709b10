// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>

#include "mapping/global_map.hpp"
#include "mapping/local_map.hpp"

namespace meander {

/// Where a map is taken from: the window around the robot, or everywhere it has been.
enum class MapPart { local, global };
template <>
struct EnumNames<MapPart> {
  static constexpr std::pair<MapPart, const char*> entries[] = {{MapPart::local, "local"}, {MapPart::global, "global"}};
};

/// The local map and the map of everywhere that it feeds.
class SonarMap {
 public:
  SonarMap(const Platform& platform, SonarModel model, const LocalMapOptions& options = {}, bool keeps_global = true)
      : local_(platform, std::move(model), options, keeps_global), robot_radius_(platform.body.radius) {
    if (keeps_global) global_.emplace(options.resolution, local_.limit());
  }

  /// Takes in one scan. Throws ArgumentError as LocalMap::step does, Error when the global map is full; both maps stay
  /// as they were then.
  void update(const Observation& observation) {
    if (global_) global_->check_room(local_.low_around(observation.odometry.pose), local_.options().size);
    local_.step(observation);
    if (global_) global_->add(local_.low(), local_.options().size, local_.increments());
    robot_ = observation.odometry.pose;
    ++scans_;
  }
  void clear() {
    local_.clear();
    if (global_) global_->clear();
    scans_ = 0;
  }

  const LocalMap& local() const { return local_; }
  const std::optional<GlobalMap>& global() const { return global_; }
  int scans() const { return scans_; }
  const Pose2& robot() const { return robot_; }  ///< where the last scan was taken
  double robot_radius() const { return robot_radius_; }
  std::size_t bytes() const { return local_.bytes() + (global_ ? global_->bytes() : 0); }

  /// 0.5: unknown.
  double probability(const Vec2& point) const;
  /// Probabilities in the odometry frame, bottom row first. Throws ArgumentError when no global map is kept.
  Grid<float> probabilities(MapPart part) const;

 private:
  LocalMap local_;
  std::optional<GlobalMap> global_;
  Pose2 robot_;
  double robot_radius_;
  int scans_ = 0;
};

}  // namespace meander
