// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meander {
namespace {

constexpr double kMostBins = 4096;
constexpr double kLeastSpacing = 1e-6;  ///< between rings [m]

std::vector<double> log_radii(const PolarLayoutOptions& o) {
  if (!(o.innermost < o.scope))
    fail("option 'map.innermost': less than map.scope = {} m expected, got {}", o.scope, o.innermost);
  std::vector<double> radii(static_cast<std::size_t>(o.rings), 0.0);
  // The factor by bisection: powers by multiplication have the same bits everywhere, the library's need not.
  const auto power = [](double base, int exponent) {
    double result = 1;
    for (int k = 0; k < exponent; ++k) result *= base;
    return result;
  };
  double low = 1, high = o.scope / o.innermost;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (o.innermost * power(middle, o.rings - 2) < o.scope ? low : high) = middle;
  }
  for (int i = 1; i < o.rings; ++i) radii[static_cast<std::size_t>(i)] = o.innermost * power(low, i - 1);
  radii.back() = o.scope;
  for (std::size_t i = 1; i < radii.size(); ++i)
    if (!(radii[i] - radii[i - 1] >= kLeastSpacing))
      fail("option 'map.innermost': {} rings at least {} m apart expected up to map.scope = {} m, got {}", o.rings,
           kLeastSpacing, o.scope, o.innermost);
  return radii;
}

std::vector<double> radii_of(const PolarLayoutOptions& o) {
  if (o.radii == PolarRadii::log) return log_radii(o);
  std::vector<double> radii;
  for (int i = 0; i < o.rings; ++i) radii.push_back(o.scope * i / (o.rings - 1));
  return radii;
}

}  // namespace

PolarLayout::PolarLayout(const PolarLayoutOptions& options)
    : rings_(options.rings),
      sectors_(options.sectors),
      spacing_(2 * kPi / options.sectors),
      even_(options.layout == PolarPlacing::fixed) {
  validate(options);
  radii_ = radii_of(options);
  for (int k = 0; k < sectors_; ++k) {
    bearings_.push_back(wrap_angle(spacing_ * k));
    const SinCos t = sin_cos(bearing(k));
    directions_.emplace_back(t.cos, t.sin);
  }
  gaps_.assign(static_cast<std::size_t>(sectors_), spacing_);
  borders_.resize(static_cast<std::size_t>(sectors_));
  sector_lookup_.resize(static_cast<std::size_t>(kSectorBins * sectors_) + 1);
  look_up_sectors();
  if (!even_) lookup_.reserve(static_cast<std::size_t>(kMostBins) + 2);
  make_lookup();
}

void PolarLayout::place(std::span<const double> radii, std::span<const double> bearings) {
  std::copy(radii.begin(), radii.end(), radii_.begin());
  for (int k = 0; k < sectors_; ++k) {
    const auto here = static_cast<std::size_t>(k);
    const SinCos t = sin_cos(bearings[here]);
    bearings_[here] = wrap_angle(bearings[here]);
    directions_[here] = {t.cos, t.sin};
    gaps_[here] = (k + 1 < sectors_ ? bearings[here + 1] : 2 * kPi) - bearings[here];
  }
  look_up_sectors();
  make_lookup();
}

/// Half way between two directions ends the one sector and begins the other.
void PolarLayout::look_up_sectors() {
  double at = 0;
  for (std::size_t k = 0; k < borders_.size(); ++k) {
    borders_[k] = (at + 0.5 * gaps_[k]) / (2 * kPi);
    at += gaps_[k];
  }
  int sector = 0;
  for (std::size_t bin = 0; bin < sector_lookup_.size(); ++bin) {
    const double turn = static_cast<double>(bin) / (kSectorBins * sectors_) - 1e-12;
    while (sector < sectors_ && turn > borders_[static_cast<std::size_t>(sector)]) ++sector;
    sector_lookup_[bin] = sector;
  }
}

/// Bins so narrow that hardly any has two rings in it and in the one before.
void PolarLayout::make_lookup() {
  edges_.resize(radii_.size() + 1);
  std::copy(radii_.begin(), radii_.end(), edges_.begin());
  edges_.back() = std::numeric_limits<double>::infinity();
  lookup_.clear();
  double closest = scope();
  for (int ring = 1; ring < rings_; ++ring) closest = std::min(closest, radius(ring) - radius(ring - 1));
  const int bins = static_cast<int>(std::min(2.5 * scope() / closest, kMostBins));
  bins_per_metre_ = bins / scope();
  int ring = 0;
  for (int bin = 0; bin <= bins + 1; ++bin) {
    // One bin less: rounding may put a radius into the bin beside its own.
    while (ring < rings_ - 1 && radius(ring) < (bin - 1) / bins_per_metre_) ++ring;
    lookup_.push_back(ring);
  }
}

int PolarLayout::apart(int a, int b) const {
  const int way = wrapped(a - b);
  return std::min(way, sectors_ - way);
}

}  // namespace meander
