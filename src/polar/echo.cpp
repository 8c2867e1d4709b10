// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/echo.hpp"

#include <algorithm>

namespace meander {
namespace {

constexpr double kNoise = 1e-3;    ///< a reading within this of the minimum is one [m]
constexpr double kOffHull = 0.04;  ///< what reads the minimum is taken to be this far from the hull [m]
constexpr double kUnknown = 0.3;   ///< a neighbour without a near echo counts as this much farther [m]
/// Share of the half cone that the neighbours do not see as well.
constexpr double kOwnCone = 0.8;

Vec2 polar_point(double radius, double angle) {
  const SinCos t = sin_cos(angle);
  return {radius * t.cos, radius * t.sin};
}

class Reader {
 public:
  Reader(const Observation& observation, const Platform& platform, const EchoRule& rule)
      : readings_(observation.readings),
        platform_(platform),
        rule_(rule),
        robot_from_odometry_(inverse(observation.odometry.pose)),
        count_(readings_.sonar.size()),
        spacing_(2 * kPi / static_cast<double>(std::max<std::size_t>(count_, 1))) {}

  Echo echo(std::size_t i) const {
    const double range = range_of(i);
    const double left = std::min(range_of((i + 1) % count_), range + kUnknown);
    const double right = std::min(range_of((i + count_ - 1) % count_), range + kUnknown);
    const Pose2 then = robot_from_odometry_ * readings_.sonar_pose[i];
    const double bearing = platform_.sonar.first + spacing_ * static_cast<double>(i);
    const Vec2 sonar = then * polar_point(platform_.sonar.radius, bearing);
    const auto at = [&](double offset) { return Vec2(sonar + polar_point(range, then.heading + bearing + offset)); };
    Echo echo;
    echo.axis = at(0);
    echo.nearest = range <= left && range <= right;
    if (echo.nearest) {
      const double own = kOwnCone * rule_.half_cone;
      const double bend = left - 2 * range + right;
      const double vertex = bend > 0 ? 0.5 * spacing_ * (right - left) / bend : 0;
      echo.point = at(std::clamp(vertex, -own, own));
      echo.places = {at(own), echo.axis, at(-own)};
    } else {
      echo.point = at(left < right ? rule_.half_cone : -rule_.half_cone);
      echo.places = {echo.point, echo.axis, echo.axis};
    }
    echo.gap = std::max(echo.point.norm() - platform_.body.radius, 0.0);
    return echo;
  }

  double range_of(std::size_t i) const {
    const double range = readings_.sonar[i];
    if (range >= rule_.range_min + kNoise) return range;
    return platform_.body.radius + kOffHull - platform_.sonar.radius;
  }

 private:
  const Readings& readings_;
  const Platform& platform_;
  const EchoRule& rule_;
  Pose2 robot_from_odometry_;
  std::size_t count_;
  double spacing_;
};

}  // namespace

void need_sonars(const char* navigator, const Platform& platform) {
  validate(platform);
  if (platform.sonar.count == 0) fail("navigator '{}' needs sonars; robot '{}' has none", navigator, platform.name);
}

void read_echoes(const Observation& observation, const Platform& platform, const EchoRule& rule,
                 std::vector<Echo>& echoes) {
  echoes.clear();
  const Reader reader(observation, platform, rule);
  const Readings& readings = observation.readings;
  for (std::size_t i = 0; i < readings.sonar.size(); ++i)
    if (readings.sonar[i] < readings.sonar_max && reader.range_of(i) <= rule.range_max)
      echoes.push_back(reader.echo(i));
}

}  // namespace meander
