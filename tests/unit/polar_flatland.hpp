// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <vector>

#include "geometry/shapes.hpp"
#include "robot/contracts.hpp"
#include "robot/kinematics.hpp"
#include "robot/platform.hpp"

namespace meander {

/// A plane with thin walls and a Nomad 200 whose sonars see the nearest wall in their cone: just enough to close the
/// loop around a navigator without the simulation.
class Flatland {
 public:
  struct Segment {
    double x0, y0, x1, y1;
  };
  explicit Flatland(std::vector<Segment> walls) : walls_(std::move(walls)) {}

  Pose2 pose{0, 0, 0};
  double least_gap = 1e9;  ///< hull to wall so far [m]

  Observation observation(const Pose2& at, double v, double w) const {
    Observation seen;
    seen.time = time_;
    seen.period = nomad_.period;
    seen.odometry = {at, v, w};
    const auto count = static_cast<std::size_t>(nomad_.sonar.count);
    seen.readings.sonar_pose.assign(count, at);
    for (std::size_t i = 0; i < count; ++i)
      seen.readings.sonar.push_back(range(at, 2 * kPi * static_cast<double>(i) / static_cast<double>(count)));
    return seen;
  }

  NavigatorStep step(const Navigator& navigator, const Subgoal& subgoal) {
    const NavigatorStep answer = navigator.step(observation(pose, v_, w_), subgoal);
    const Command command = limited(answer.command, nomad_.body);
    constexpr int kParts = 8;
    for (int i = 0; i < kParts; ++i) {
      const double dt = nomad_.period / kParts;
      const Ramped v = ramped(v_, command.v, nomad_.body.a_v, dt), w = ramped(w_, command.w, nomad_.body.a_w, dt);
      pose = arc(pose, v.mean, w.mean, dt);
      v_ = v.end;
      w_ = w.end;
      for (const Segment& s : walls_)
        least_gap =
            std::min(least_gap, distance_to_segment(pose.position(), {s.x0, s.y0}, {s.x1, s.y1}) - nomad_.body.radius);
    }
    time_ += nomad_.period;
    return answer;
  }

 private:
  double range(const Pose2& at, double bearing) const {
    constexpr double kHalfCone = 0.218, kLeast = 0.152, kMost = 6.477;
    constexpr int kRays = 9;
    const SinCos axis = sin_cos(at.heading + bearing);
    const Vec2 from = at.position() + nomad_.sonar.radius * Vec2(axis.cos, axis.sin);
    double nearest = kMost;
    for (int k = 0; k < kRays; ++k) {
      const SinCos t = sin_cos(at.heading + bearing + kHalfCone * (2.0 * k / (kRays - 1) - 1));
      for (const Segment& s : walls_) nearest = std::min(nearest, hit(from, {t.cos, t.sin}, s));
    }
    return std::max(nearest, kLeast);
  }

  static double hit(const Vec2& from, const Vec2& direction, const Segment& s) {
    const Vec2 a(s.x0 - from.x(), s.y0 - from.y()), d(s.x1 - s.x0, s.y1 - s.y0);
    const double cross = direction.x() * d.y() - direction.y() * d.x();
    if (cross == 0) return 1e9;
    const double way = (a.x() * d.y() - a.y() * d.x()) / cross;
    const double share = (a.x() * direction.y() - a.y() * direction.x()) / cross;
    return way >= 0 && share >= 0 && share <= 1 ? way : 1e9;
  }

  std::vector<Segment> walls_;
  Platform nomad_ = platform("nomad200");
  double v_ = 0, w_ = 0, time_ = 0;
};

}  // namespace meander
