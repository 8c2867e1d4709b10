// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/vfh_plus.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "polar/echo.hpp"
#include "polar/near_points.hpp"

namespace meander {
namespace {

/// An opening of the histogram: its first sector and how many there are, counter-clockwise.
struct Valley {
  int first;
  int count;
};

class VfhPlus {
 public:
  VfhPlus(const Platform& platform, const VfhPlusOptions& options)
      : platform_(platform),
        options_(options),
        memory_(platform, options.memory),
        cones_(platform, options.memory.range_min, options.half_cone),
        steering_(platform, options.steering),
        trap_(options.patience, options.progress),
        sector_(2 * kPi / options.sectors),
        density_(static_cast<std::size_t>(options.sectors)),
        blocked_(density_.size()),
        masked_(density_.size()) {}

  void reset() { *this = VfhPlus(platform_, options_); }

  NavigatorStep step(const Observation& observation, const Subgoal& subgoal) {
    const Pose2& pose = observation.odometry.pose;
    memory_.remember(observation.readings);
    if (const auto there = arrival(observation, subgoal, platform_.body)) return *there;
    const Vec2 to_subgoal = inverse(pose) * subgoal.position;
    // [UB98+] What lies behind the subgoal is in nobody's way to it.
    reach_ = std::min(options_.window, to_subgoal.norm() + platform_.body.radius + options_.enlarge);
    // Steering looks as far as braking leads, however near the histogram ends.
    const double farthest = std::max(reach_, steering_.reach(observation));
    points_near(memory_, pose, platform_.body.radius, farthest, points_);
    cones_.add(observation, farthest, points_);
    fill(pose.heading);
    hysteresis();
    mask(pose.heading, observation.odometry.v);
    const double target = pose.heading + angle_of(to_subgoal.y(), to_subgoal.x());
    const std::optional<double> direction = best_direction(target, pose.heading);
    NavigatorStep step{command(direction, observation, to_subgoal), NavigatorStatus::driving, {}};
    if (trap_.update(observation.time, pose.position(), subgoal.position)) {
      step.status = NavigatorStatus::trapped;
      step.reason = fmt::format("no progress for {:g} s, {:.2f} m from the subgoal: {}", options_.patience,
                                to_subgoal.norm(), direction ? "the openings lead away" : "no opening");
    }
    return step;
  }

 private:
  int sectors() const { return options_.sectors; }
  std::size_t at(int sector) const { return static_cast<std::size_t>((sector % sectors() + sectors()) % sectors()); }
  double angle_at(int sector) const { return wrap_angle(sector * sector_); }

  /// [UB98] eqs. (1) to (4): each point adds its magnitude, less the farther it is, to all sectors that it blocks for a
  /// robot of its size. Sectors have fixed directions in the odometry frame, so that they can keep their state.
  void fill(double heading) {
    std::fill(density_.begin(), density_.end(), 0.0);
    const double size = platform_.body.radius + options_.enlarge;
    for (const Vec2& point : points_) {
      const double distance = point.norm();
      if (distance > reach_) continue;
      const double share = distance / reach_;
      const double bearing = heading + angle_of(point.y(), point.x());
      const double sine = std::min(1.0, size / distance);
      const double half = angle_of(sine, std::sqrt(1 - sine * sine));
      const int first = static_cast<int>(std::ceil((bearing - half) / sector_));
      const int last = static_cast<int>(std::floor((bearing + half) / sector_));
      for (int k = first; k <= last; ++k) density_[at(k)] += 1 - share * share;
    }
  }

  /// [UB98] eq. (5): the binary histogram.
  void hysteresis() {
    for (std::size_t k = 0; k < density_.size(); ++k) {
      if (density_[k] > options_.high) blocked_[k] = 1;
      if (density_[k] < options_.low) blocked_[k] = 0;
    }
  }

  /// [UB98] eqs. (6) to (10): directions that lie behind an obstacle on the robot's turning circle are masked.
  /// [UB98+] The circle is that of the present speed: a robot that stands turns on the spot.
  void mask(double heading, double v) {
    const double turning = v / std::max(platform_.body.w_max, 1e-9);
    const double reach = turning + platform_.body.radius + options_.enlarge;
    double left = kPi, right = kPi;  // how far it may turn to either side
    for (const Vec2& point : points_) {
      const double bearing = angle_of(point.y(), point.x());
      if (bearing >= 0 && (point - Vec2(0, turning)).norm() < reach) left = std::min(left, bearing);
      if (bearing < 0 && (point + Vec2(0, turning)).norm() < reach) right = std::min(right, -bearing);
    }
    for (int k = 0; k < sectors(); ++k) {
      const double turn = angle_between(heading, angle_at(k));
      const bool out_of_reach = v > kStanding && (turn > left || turn < -right);
      masked_[at(k)] = blocked_[at(k)] || out_of_reach;
    }
    if (std::all_of(masked_.begin(), masked_.end(), [](char m) { return m != 0; })) masked_ = blocked_;
  }

  void find_valleys() {
    valleys_.clear();
    const auto wall = std::find_if(masked_.begin(), masked_.end(), [](char m) { return m != 0; });
    if (wall == masked_.end()) {
      valleys_.push_back({0, sectors()});
      return;
    }
    const int begin = static_cast<int>(wall - masked_.begin());
    for (int k = begin + 1; k < begin + sectors(); ++k) {
      if (masked_[at(k)]) continue;
      Valley valley{k, 0};
      for (; !masked_[at(k)]; ++k) ++valley.count;
      valleys_.push_back(valley);
    }
  }

  /// [UB98] eqs. (11) to (15): the middle of narrow openings; near the edges of wide ones, and the subgoal itself.
  std::optional<double> best_direction(double target, double heading) {
    find_valleys();
    std::optional<double> best;
    double least = 0;
    const auto consider = [&](double angle) {
      const double cost = options_.goal_weight * std::abs(angle_between(angle, target)) +
                          options_.heading_weight * std::abs(angle_between(angle, heading)) +
                          options_.previous_weight * std::abs(angle_between(angle, previous_.value_or(heading)));
      if (!best || cost < least) best = wrap_angle(angle), least = cost;
    };
    for (const Valley& valley : valleys_) {
      const double first = valley.first * sector_, last = (valley.first + valley.count - 1) * sector_;
      const double edge = 0.5 * options_.wide_valley * sector_;
      if (valley.count <= options_.wide_valley) {
        consider(0.5 * (first + last));
        continue;
      }
      if (valley.count < sectors()) consider(first + edge), consider(last - edge);
      const double into = angle_between(first, target);
      const double share = into < 0 ? into + 2 * kPi : into;
      if (valley.count == sectors() || (share >= edge && share <= last - first - edge)) consider(target);
    }
    previous_ = best;
    return best;
  }

  Command command(const std::optional<double>& direction, const Observation& observation,
                  const Vec2& to_subgoal) const {
    const double heading = observation.odometry.pose.heading;
    if (!direction)
      return steering_.turn(angle_of(to_subgoal.y(), to_subgoal.x()) >= 0 ? kPi / 2 : -kPi / 2, observation);
    return steering_.towards(angle_between(heading, *direction), to_subgoal.norm(), observation, points_);
  }

  static constexpr double kStanding = 0.02;  ///< slower than this the robot can turn anywhere [m/s]

  Platform platform_;
  VfhPlusOptions options_;
  SonarMemory memory_;
  ConeEnds cones_;
  Steering steering_;
  TrapWatch trap_;
  double sector_;
  double reach_ = 0;  ///< farther points do not count now [m]
  std::vector<double> density_;
  std::vector<char> blocked_;
  std::vector<char> masked_;
  std::vector<Vec2> points_;
  std::vector<Valley> valleys_;
  std::optional<double> previous_;  ///< direction chosen last, in the odometry frame
};

}  // namespace

Navigator vfh_plus(const Platform& platform, const VfhPlusOptions& options) {
  need_sonars("vfh_plus", platform);
  validate(options);
  auto vfh = std::make_shared<VfhPlus>(platform, options);
  return {.name = "vfh_plus",
          .step = [vfh](const Observation& o, const Subgoal& s) { return vfh->step(o, s); },
          .reset = [vfh] { vfh->reset(); },
          .body_radius = platform.body.radius};
}

}  // namespace meander
