// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/trace.hpp"

#include <opencv2/imgproc.hpp>

#include "world/outline.hpp"

namespace meander {
namespace {

/// Patch of solid cells that hang together, also across corners; 0 where free.
Grid<int> patches(const Grid<std::uint8_t>& solid) {
  Grid<int> labels(solid.width(), solid.height());
  if (labels.cells().empty()) return labels;
  const cv::Mat in(solid.height(), solid.width(), CV_8U, const_cast<std::uint8_t*>(solid.cells().data()));
  cv::Mat out(solid.height(), solid.width(), CV_32S, labels.cells().data());
  cv::connectedComponents(in, out, 8, CV_32S);
  return labels;
}

struct Patch {
  Polygon polygon;
  std::int64_t area_cells = 0;
};

}  // namespace

Traced trace(const Grid<std::uint8_t>& solid, const TraceOptions& options, const Work& work) {
  validate(options);
  const GridFrame& frame = solid.frame;
  const Grid<int> labels = patches(solid);
  std::vector<int> patch_of(labels.cells().size() + 1, -1);
  std::vector<Patch> found;
  walk_outlines(solid, work, [&](const Outline& outline) {
    // The outer outline holds the lowest cell, so it comes before the holes.
    int& index = patch_of[static_cast<std::size_t>(labels[outline.inside])];
    if (index < 0) {
      index = static_cast<int>(found.size());
      found.emplace_back();
    }
    std::vector<Vec2> ring = straightened(outline, options.epsilon);
    for (Vec2& point : ring) point = frame.origin * Vec2(frame.resolution * point);
    Patch& patch = found[static_cast<std::size_t>(index)];
    patch.area_cells += outline.area_cells;
    if (outline.hole)
      patch.polygon.holes.push_back(std::move(ring));
    else
      patch.polygon.outer = std::move(ring);
  });

  Traced traced;
  const double cell_area = frame.resolution * frame.resolution;
  for (Patch& patch : found) {
    if (static_cast<double>(patch.area_cells) * cell_area < options.min_area * (1 - 1e-9)) {
      ++traced.specks;
      continue;
    }
    traced.edges += patch.polygon.outer.size();
    for (const auto& hole : patch.polygon.holes) traced.edges += hole.size();
    traced.holes += patch.polygon.holes.size();
    traced.solids.push_back(std::move(patch.polygon));
  }
  return traced;
}

}  // namespace meander
