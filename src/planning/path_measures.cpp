// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/path_measures.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace meander {
namespace {

/// |Change of direction| at each inner point [rad].
std::vector<double> turns(const std::vector<Vec2>& points) {
  std::vector<double> turns;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec2 before = points[i] - points[i - 1], after = points[i + 1] - points[i];
    turns.push_back(std::abs(angle_of(cross(before, after), before.dot(after))));
  }
  return turns;
}

}  // namespace

std::vector<Vec2> resampled(const std::vector<Vec2>& points, double spacing) {
  std::vector<Vec2> samples;
  if (points.empty()) return samples;
  samples.push_back(points.front());
  double due = spacing;  // length until the next sample
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 way = points[i] - points[i - 1];
    const double length = way.norm();
    double done = 0;
    for (; done + due <= length; due = spacing) {
      done += due;
      samples.push_back(points[i - 1] + way * (done / length));
    }
    due -= length - done;
  }
  if (samples.size() > 1 && (samples.back() - points.back()).norm() < 1e-6 * spacing) samples.pop_back();
  if (points.size() > 1) samples.push_back(points.back());
  return samples;
}

PathMeasures measure_path(const std::vector<Vec2>& points, const Clearance& clearance, const Work& work) {
  PathMeasures measures;
  if (points.empty()) return measures;
  measures.clearance_min = clearance.of(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i % 64 == 0) work.poll();
    measures.length += (points[i] - points[i - 1]).norm();
    measures.clearance_min =
        std::min(measures.clearance_min, clearance.of(points[i - 1], points[i], measures.clearance_min));
  }
  for (const double turn : turns(points)) measures.turning += turn;
  const std::vector<Vec2> samples = resampled(points, 1);
  const std::vector<double> bends = turns(samples);
  // The last piece is shorter than a cell: its angle says little.
  for (std::size_t i = 0; i + 1 < bends.size(); ++i) measures.curvature = std::max(measures.curvature, bends[i]);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i % 64 == 0) work.poll();
    measures.clearance_mean += std::max(clearance.of(samples[i]), 0.0);
  }
  measures.clearance_mean /= static_cast<double>(samples.size());
  return measures;
}

bool certified(const PathMeasures& measures, double radius) { return measures.clearance_min >= radius - 1e-9; }

}  // namespace meander
