// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meander {
namespace {

constexpr double kMostBins = 4096;

std::vector<double> log_radii(const PolarLayoutOptions& o) {
  if (!(o.innermost < o.scope))
    fail("option 'innermost': less than the scope {} m expected, got {}", o.scope, o.innermost);
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
    : rings_(options.rings), sectors_(options.sectors), spacing_(2 * kPi / options.sectors) {
  validate(options);
  radii_ = radii_of(options);
  for (int k = 0; k < sectors_; ++k) {
    const SinCos t = sin_cos(bearing(k));
    directions_.emplace_back(t.cos, t.sin);
  }
  make_lookup();
}

/// Bins so narrow that hardly any has two rings in it and in the one before.
void PolarLayout::make_lookup() {
  edges_ = radii_;
  edges_.push_back(std::numeric_limits<double>::infinity());
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
