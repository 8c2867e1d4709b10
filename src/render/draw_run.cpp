// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_run.hpp"

#include <algorithm>

#include "render/draw_parts.hpp"

namespace meander {
namespace {

/// Unbroken runs of points, without the ones nearer than `least` to the one before.
std::vector<std::vector<Vec2>> ways(std::span<const Pose2> poses, double least) {
  std::vector<std::vector<Vec2>> runs(1);
  for (const Pose2& pose : poses) {
    const Vec2 p = pose.position();
    if (!p.allFinite()) {
      if (!runs.back().empty()) runs.emplace_back();
    } else if (runs.back().empty() || (p - runs.back().back()).norm() >= least) {
      runs.back().push_back(p);
    }
  }
  std::erase_if(runs, [](const auto& run) { return run.size() < 2; });
  return runs;
}

void draw_goal(DrawList& list, const TrackGoal& goal, std::size_t number, double unit, const Theme& theme) {
  const Color color = goal.reached ? theme.goal : theme.contact;
  list.items.push_back(DrawDisc{{goal.position, goal.tolerance}, faded(color, 70), Mark::ground});
  list.items.push_back(DrawDisc{{goal.position, goal.tolerance}, color, Mark::goal, 0.2 * unit});
  list.items.push_back(DrawDisc{{goal.position, 1.15 * unit}, color, Mark::goal});
  list.items.push_back(DrawText{goal.position - Vec2(0, 0.6 * unit), fmt::format("{}", number), 1.2 * unit,
                                Color{255, 255, 255}, Color{0, 0, 0, 0}, Align::center, Mark::goal});
}

void draw_contact(DrawList& list, const Vec2& at, double unit, const Theme& theme) {
  for (const double side : {-1.0, 1.0})
    list.items.push_back(DrawPolyline{{at + unit * Vec2(-0.9, -0.9 * side), at + unit * Vec2(0.9, 0.9 * side)},
                                      false,
                                      0.4 * unit,
                                      theme.contact,
                                      Mark::contact});
}

/// Points of an arc around the transducer, from its right edge to its left.
std::vector<Vec2> arc_points(const Pose2& transducer, double range, double half_cone) {
  const int steps = std::clamp(static_cast<int>(half_cone / radians(2.5)) + 1, 2, 72);
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) {
    const SinCos t = sin_cos(half_cone * (2.0 * i / steps - 1));
    points.push_back(transducer * Vec2(range * t.cos, range * t.sin));
  }
  return points;
}

}  // namespace

void draw_track(DrawList& list, const Track& track, const Theme& theme) {
  const double unit = picture_unit(list.view);
  for (auto& way : ways(track.poses, 0.02 * unit)) {
    list.items.push_back(DrawPolyline{way, false, 2 * track.radius, theme.sweep, Mark::sweep});
    list.items.push_back(DrawPolyline{std::move(way), false, 0.35 * unit, theme.path, Mark::path});
  }
  for (std::size_t i = 0; i < track.goals.size(); ++i) draw_goal(list, track.goals[i], i + 1, unit, theme);
  for (const Vec2& at : track.contacts) draw_contact(list, at, unit, theme);
  if (track.poses.empty()) return;
  list.items.push_back(DrawDisc{{track.poses.front().position(), track.radius}, theme.start, Mark::start, 0.3 * unit});
  draw_robot(list, track.poses.back(), track.radius, theme);
}

void draw_robot(DrawList& list, const Pose2& pose, double radius, const Theme& theme) {
  list.items.push_back(DrawBody{{pose.position(), radius}, pose.heading, theme.robot, theme.robot_nose, Mark::robot});
}

void draw_readings(DrawList& list, const Scan& scan, const Theme& theme) {
  if (scan.transducers.size() != scan.ranges.size())
    fail("draw_readings: as many ranges as transducers expected, got {} and {}", scan.ranges.size(),
         scan.transducers.size());
  const double unit = picture_unit(list.view);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const bool heard = scan.ranges[i] < scan.range_max;
    std::vector<Vec2> arc = arc_points(scan.transducers[i], scan.ranges[i], scan.half_cone);
    std::vector<Vec2> cone = arc;
    cone.push_back(scan.transducers[i].position());
    const auto alpha = static_cast<std::uint8_t>(heard ? theme.cone.a : theme.cone.a / 3);
    list.items.push_back(DrawArea{{std::move(cone), {}}, faded(theme.cone, alpha), Mark::cone});
    if (heard) list.items.push_back(DrawPolyline{std::move(arc), false, 0.4 * unit, theme.echo, Mark::echo});
  }
}

}  // namespace meander
