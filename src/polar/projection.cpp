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
      bits_(words_ * static_cast<std::size_t>(layout.sectors())) {}

void ObstructedUnits::clear() { std::fill(bits_.begin(), bits_.end(), std::uint64_t{0}); }

void ObstructedUnits::obstruct(int sector, int first, int last) {
  first = std::max(first, 1);
  last = std::min(last, rings_ - 2);
  std::uint64_t* words = bits_.data() + static_cast<std::size_t>(sector) * words_;
  for (int from = first; from <= last;) {
    const int to = std::min(last, from | 63);
    words[static_cast<std::size_t>(from) >> 6] |= (~std::uint64_t{0} >> (63 - (to - from))) << (from & 63);
    from = to + 1;
  }
}

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
  const int first = floor_of((middle - half) / layout_->spacing());
  const int last = floor_of((middle + half) / layout_->spacing()) + 1;
  const int count = std::min(last - first + 1, layout_->sectors());
  int sector = layout_->wrapped(first);
  for (int k = 0; k < count; ++k) {
    const Vec2& u = layout_->direction(sector);
    add_to_sector(sector, point.dot(u), cross(u, point));
    if (++sector == layout_->sectors()) sector = 0;
  }
}

/// Along a sector's direction a circle covers the radii along -+ sqrt(radius^2 - aside^2).
void Projection::add_to_sector(int sector, double along, double aside) {
  for (std::size_t k = 0; k < layers_.size(); ++k) {
    const double square = squares_[k] - aside * aside;
    if (square < 0) continue;
    const double half = std::sqrt(square);
    if (along + half < 0) continue;
    const int first = layout_->first_ring_from(along - half);
    int last = layout_->first_ring_from(along + half);
    if (last < layout_->rings() && layout_->radius(last) > along + half) --last;
    if (first <= last) layers_[k].obstruct(sector, first, last);
  }
}

}  // namespace meander
