// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meander {

ObstructedUnits::ObstructedUnits(const PolarLayout& layout)
    : rings_(layout.rings()),
      words_((static_cast<std::size_t>(layout.rings()) + 63) / 64),
      bits_(words_ * static_cast<std::size_t>(layout.sectors())),
      before_((static_cast<std::size_t>(layout.rings()) + 1) * words_) {
  for (int end = 0; end <= rings_; ++end)
    for (int ring = 1; ring < std::min(end, rings_ - 1); ++ring)
      before_[static_cast<std::size_t>(end) * words_ + (static_cast<std::size_t>(ring) >> 6)] |= std::uint64_t{1}
                                                                                                 << (ring & 63);
}

void ObstructedUnits::clear() { std::fill(bits_.begin(), bits_.end(), std::uint64_t{0}); }

Projection::Projection(const PolarLayout& layout, std::vector<double> radii)
    : layout_(&layout),
      radii_(std::move(radii)),
      layers_(radii_.size(), ObstructedUnits(layout)),
      reaches_(radii_.size(), std::numeric_limits<double>::infinity()),
      squares_(radii_.size()) {}

void Projection::clear() {
  for (ObstructedUnits& layer : layers_) layer.clear();
}

void Projection::add(const Vec2& point) {
  const double distance = point.norm();
  if (!(distance > 2 * kCentreFree)) return;
  double largest = 0;
  for (std::size_t k = 0; k < radii_.size(); ++k) {
    const double radius = std::min(radii_[k], distance - kCentreFree);
    const bool within = distance - radii_[k] <= reaches_[k];
    squares_[k] = within ? radius * radius : -1;
    if (within) largest = std::max(largest, radius);
  }
  // Sectors whose direction passes within the largest circle, and a little more.
  const double half = 2 * kCoarse + coarse_angle(largest, std::sqrt(distance * distance - largest * largest));
  const double middle = coarse_angle(point.y(), point.x());
  int first, last;
  if (layout_->even()) {
    first = floor_of((middle - half) / layout_->spacing());
    last = floor_of((middle + half) / layout_->spacing()) + 1;
  } else {
    const int from = layout_->nearest_sector(middle - half), to = layout_->nearest_sector(middle + half);
    int more = layout_->wrapped(to - from);
    // Into the same sector again, from the other side.
    if (more == 0 && 2 * half >= 2 * kPi - layout_->width(from)) more = layout_->sectors() - 1;
    first = from - 1;
    last = from + more + 1;
  }
  const int count = std::min(last - first + 1, layout_->sectors());
  for (std::size_t k = 0; k < layers_.size(); ++k)
    if (squares_[k] >= 0) add_to_layer(k, point, squares_[k], layout_->wrapped(first), count);
}

/// Along a sector's direction a circle covers the radii along -+ sqrt(radius^2 - aside^2).
void Projection::add_to_layer(std::size_t k, const Vec2& point, double square, int sector, int count) {
  for (; count > 0; --count, sector = sector + 1 == layout_->sectors() ? 0 : sector + 1) {
    const Vec2& u = layout_->direction(sector);
    const double aside = cross(u, point), left = square - aside * aside;
    if (left < 0) continue;
    const double along = point.dot(u), half = std::sqrt(left);
    layers_[k].add(sector, layout_->first_ring_from(along - half), layout_->first_ring_beyond(along + half));
  }
}

}  // namespace meander
