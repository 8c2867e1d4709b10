// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "autonomy/map_navigators.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/log_odds.hpp"
#include "polar/polar_navigator.hpp"
#include "robot/kinematics.hpp"

namespace meander {
namespace {

constexpr int kSamples = 12;  ///< poses of a way that are looked at
constexpr int kSpeeds = 5;    ///< shares of the commanded speed that are tried: 1, 3/4, 1/2, 1/4, 0

class MapSafety {
 public:
  MapSafety(Navigator navigator, const Platform& platform, std::shared_ptr<LocalMap> map,
            const MapSafetyOptions& options)
      : navigator_(std::move(navigator)), platform_(platform), map_(std::move(map)), options_(options) {}

  NavigatorStep step(const Observation& observation, const Subgoal& subgoal) {
    map_->step(observation);
    NavigatorStep step = navigator_.step(observation, subgoal);
    const Command wanted = limited(step.command, platform_.body);
    look_around(observation, wanted);
    for (int k = 0; k < kSpeeds; ++k) {
      step.command = slower(wanted, 1 - static_cast<double>(k) / (kSpeeds - 1));
      if (is_safe(observation, step.command)) break;
    }
    if (step.command != wanted && step.reason.empty()) step.reason = "slowed down by the map";
    return step;
  }
  void reset() {
    map_->clear();
    navigator_.reset();
  }

 private:
  static Command slower(const Command& command, double share) {
    return {share * command.v, command.w, share * command.vy};
  }
  /// Time of a cycle and of braking from the faster of what is and what is commanded [s].
  double horizon(const Observation& seen, const Command& command) const {
    const double fastest = std::max(Vec2(seen.odometry.v, seen.odometry.vy).norm(), Vec2(command.v, command.vy).norm());
    return platform_.period + 0.5 * fastest / platform_.body.a_v;
  }
  void look_around(const Observation& seen, const Command& command) {
    const double reach = horizon(seen, command) * platform_.body.v_max + platform_.body.radius + options_.margin;
    occupied_cells(*map_, options_.obstacles.occupied, seen.odometry.pose.position(), reach, near_);
  }
  double nearest(const Vec2& at) const {
    double square = 1e9;
    for (const Vec2& point : near_) square = std::min(square, (point - at).squaredNorm());
    return std::sqrt(square);
  }
  /// Along the way of the command, which takes effect at once and whose braking lasts half its time at full speed.
  bool is_safe(const Observation& seen, const Command& command) const {
    if (command.v == 0 && command.vy == 0) return true;
    const Pose2& from = seen.odometry.pose;
    const double duration = horizon(seen, command), least = platform_.body.radius + options_.margin;
    double before = nearest(from.position());
    for (int i = 1; i <= kSamples; ++i) {
      const double here = nearest(twist(from, command.v, command.vy, command.w, duration * i / kSamples).position());
      if (here < least && here < before) return false;
      before = here;
    }
    return true;
  }

  Navigator navigator_;
  Platform platform_;
  std::shared_ptr<LocalMap> map_;
  MapSafetyOptions options_;
  std::vector<Vec2> near_;
};

}  // namespace

void occupied_cells(const LocalMap& map, double occupied, const Vec2& from, double reach, std::vector<Vec2>& points) {
  points.clear();
  const float threshold = log_odds_of(occupied);
  const int size = map.options().size;
  for (int y = map.low().y; y < map.low().y + size; ++y)
    for (int x = map.low().x; x < map.low().x + size; ++x) {
      const float told = map.log_odds(Cell{x, y});
      if (told == 0 || told < threshold) continue;
      const Vec2 center = map.center({x, y});
      if ((center - from).squaredNorm() <= reach * reach) points.push_back(center);
    }
}

Navigator polar_on_map(const Platform& platform, std::shared_ptr<LocalMap> map, const PolarOptions& polar,
                       const MapObstacleOptions& options) {
  validate(options);
  PolarParts parts;
  parts.obstacles = [map, options, reach = polar.map.layout.scope + platform.body.radius](const Observation& seen,
                                                                                          std::vector<Vec2>& points) {
    map->step(seen);
    occupied_cells(*map, options.occupied, seen.odometry.pose.position(), reach, points);
  };
  Navigator navigator = polar_navigator(platform, polar, std::move(parts));
  navigator.name = "polar_map";
  navigator.reset = [map, forget = navigator.reset] {
    map->clear();
    forget();
  };
  return navigator;
}

Navigator with_map_safety(Navigator navigator, const Platform& platform, std::shared_ptr<LocalMap> map,
                          const MapSafetyOptions& options) {
  validate(options);
  check_body(navigator, platform.body.radius);
  const std::string name = navigator.name + "+safety";
  const auto safety = std::make_shared<MapSafety>(std::move(navigator), platform, std::move(map), options);
  return {.name = name,
          .step = [safety](const Observation& o, const Subgoal& s) { return safety->step(o, s); },
          .reset = [safety] { safety->reset(); },
          .body_radius = platform.body.radius};
}

}  // namespace meander
