// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/layout_organiser.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// Readings between two neighbours count up to so many times the average; what is above counts for all alike.
constexpr double kMost = 5;

PolarLayoutOptions staying(PolarLayoutOptions options) {
  options.layout = PolarPlacing::fixed;
  return options;
}

}  // namespace

LayoutOrganiser::LayoutOrganiser(const PolarLayoutOptions& layout, const LayoutOrganiserOptions& options)
    : options_(options), fixed_(staying(layout)) {
  radii_.fixed = fixed_.radii();
  for (int k = 0; k <= fixed_.sectors(); ++k) bearings_.fixed.push_back(fixed_.spacing() * k);
  reset();
}

void LayoutOrganiser::reset() {
  for (Axis* axis : {&radii_, &bearings_}) {
    const std::size_t cells = axis->fixed.size() - 1;
    axis->hits.assign(cells, 1 / static_cast<double>(cells));
    axis->wanted = axis->placed = axis->fixed;
  }
}

void LayoutOrganiser::forget(Axis& axis) const {
  for (double& hits : axis.hits) hits *= 1 - options_.rate;
}

void LayoutOrganiser::learn(std::span<const MappedPoint> points) {
  if (points.empty()) return;
  forget(radii_), forget(bearings_);
  const double weight = options_.rate / static_cast<double>(points.size());
  for (const MappedPoint& point : points) {
    const int ring = std::clamp(fixed_.first_ring_from(point.position.norm()), 1, fixed_.rings() - 1);
    radii_.hits[static_cast<std::size_t>(ring - 1)] += weight;
    const int sector = floor_of(coarse_angle(point.position.y(), point.position.x()) / fixed_.spacing());
    bearings_.hits[static_cast<std::size_t>(fixed_.wrapped(sector))] += weight;
  }
}

/// Quantiles of the mixture: as much of it lies between any two neighbours.
void LayoutOrganiser::place(Axis& axis) const {
  const std::size_t cells = axis.hits.size();
  const double average = 1 / static_cast<double>(cells);
  double sum = 0;
  for (const double hits : axis.hits) sum += std::min(hits, kMost * average);
  const double equal = (1 - options_.share) + options_.share * (1 - sum);
  const auto mass = [&](std::size_t cell) {
    return equal * average + options_.share * std::min(axis.hits[cell], kMost * average);
  };
  double before = 0, here = mass(0);
  for (std::size_t k = 1, cell = 0; k < cells; ++k) {
    const double quantile = static_cast<double>(k) * average;
    while (before + here < quantile && cell + 1 < cells) {
      before += here;
      here = mass(++cell);
    }
    const double share = std::min(1.0, (quantile - before) / here);
    axis.wanted[k] = axis.fixed[cell] + share * (axis.fixed[cell + 1] - axis.fixed[cell]);
  }
}

bool LayoutOrganiser::off(const Axis& axis) const {
  for (std::size_t k = 1; k + 1 < axis.placed.size(); ++k) {
    const double room = std::min(axis.placed[k + 1] - axis.placed[k], axis.placed[k] - axis.placed[k - 1]);
    if (std::abs(axis.wanted[k] - axis.placed[k]) > options_.step * room) return true;
  }
  return false;
}

bool LayoutOrganiser::organise(PolarLayout& layout) {
  place(radii_), place(bearings_);
  if (!off(radii_) && !off(bearings_)) return false;
  std::copy(radii_.wanted.begin(), radii_.wanted.end(), radii_.placed.begin());
  std::copy(bearings_.wanted.begin(), bearings_.wanted.end(), bearings_.placed.begin());
  layout.place(radii_.placed, std::span(bearings_.placed).first(bearings_.placed.size() - 1));
  return true;
}

}  // namespace meander
