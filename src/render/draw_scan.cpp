// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_scan.hpp"

#include "geometry/angle.hpp"
#include "render/draw_run.hpp"

namespace meander {

std::vector<Pose2> transducer_poses(const RingLayout& layout, const Pose2& pose) {
  std::vector<Pose2> poses;
  for (int i = 0; i < layout.count; ++i) {
    const double bearing = layout.first + 2 * kPi * i / layout.count;
    const SinCos t = sin_cos(bearing);
    poses.push_back(pose * Pose2{layout.radius * t.cos, layout.radius * t.sin, wrap_angle(bearing)});
  }
  return poses;
}

void draw_scan(DrawList& list, const RobotLook& look, const Pose2& pose, std::span<const double> ranges,
               const Theme& theme) {
  const std::vector<Pose2> transducers = transducer_poses(look.ring, pose);
  if (transducers.size() != ranges.size()) return;
  draw_readings(list, {transducers, ranges, look.half_cone, look.range_max}, theme);
}

}  // namespace meander
