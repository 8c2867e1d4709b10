// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "polar/polar_weights.hpp"

#include <algorithm>
#include <cmath>

namespace meander {
namespace {

/// What is left of ring 1 at the centre, which has no neighbours of its own: less, so that it is no local maximum.
constexpr double kCentre = 0.999;
/// beta times the largest eigenvalue, which [LM99] wants below 1.
constexpr double kStability = 0.98;

/// [LM99+] The screened Laplacian lap v = kappa^2 v in finite volumes: row-bounded whatever the radii, so that a stable
/// equilibrium exists for every target and every set of obstacles, and -log v / kappa is a smoothed distance.
RingWeights volume(const PolarLayout& layout, int i, double kappa) {
  const bool rim = i == layout.rings() - 1;
  const double r = layout.radius(i), in = 0.5 * (r + layout.radius(i - 1));
  const double out = rim ? r : 0.5 * (r + layout.radius(i + 1));
  RingWeights w;
  w.inward = in * layout.spacing() / (r - layout.radius(i - 1));
  w.outward = rim ? 0 : out * layout.spacing() / (layout.radius(i + 1) - r);
  w.lateral = (out - in) / (r * layout.spacing());
  w.total = w.inward + w.outward + 2 * w.lateral + kappa * kappa * r * layout.spacing() * (out - in);
  return w;
}

/// [LM99] f(x) = 1 / x of the distance between the units, here in units of the outermost rings' distance.
RingWeights inverse_distance(const PolarLayout& layout, int i) {
  const double unit = layout.radius(layout.rings() - 1) - layout.radius(layout.rings() - 2);
  const Vec2 here = layout.position(i, 0);
  const auto f = [&](int ring, int sector) { return unit / (layout.position(ring, sector) - here).norm(); };
  RingWeights w;
  w.lateral = f(i, 1);
  w.inward = f(i - 1, 0);
  w.inward_diagonal = i > 1 ? f(i - 1, 1) : 0;  // the centre is one place
  if (i == layout.rings() - 1) return w;
  w.outward = f(i + 1, 0);
  w.outward_diagonal = f(i + 1, 1);
  return w;
}

/// [LM99, Figure 1] the grid taken as a square lattice: 1 along it, 1 / sqrt 2 across.
RingWeights square(const PolarLayout& layout, int i) {
  const double across = std::sqrt(0.5);
  const bool rim = i == layout.rings() - 1;
  return {.inward = 1,
          .outward = rim ? 0.0 : 1.0,
          .lateral = 1,
          .inward_diagonal = i > 1 ? across : 0,
          .outward_diagonal = rim ? 0 : across};
}

void check(const RingWeights& w, int ring) {
  for (const double x : {w.inward, w.outward, w.lateral, w.inward_diagonal, w.outward_diagonal, w.total})
    if (!(x >= 0) || !std::isfinite(x)) fail("weights of ring {}: finite numbers >= 0 expected, got {}", ring, x);
  if (!(w.total > 0)) fail("weights of ring {}: total > 0 expected, got {}", ring, w.total);
}

/// Ring 0 follows ring 1 and nothing lies beyond the rim.
void close(std::vector<RingWeights>& weights) {
  weights.front() = {.outward = kCentre, .total = 1};
  weights.back().outward = weights.back().outward_diagonal = 0;
  if (weights.size() > 1) weights[1].inward_diagonal = 0;
}

}  // namespace

double largest_eigenvalue(const std::vector<RingWeights>& weights) {
  const std::size_t n = weights.size();
  std::vector<double> v(n, 1.0), next(n);
  double eigenvalue = 0;
  for (int round = 0; round < 20000; ++round) {
    double largest = 0;
    for (std::size_t i = 1; i < n; ++i) {
      const RingWeights& w = weights[i];
      // One more of itself keeps rings that only alternate from flipping for ever; it is taken off below.
      const double inner = i == 1 ? kCentre * v[1] : v[i - 1];
      next[i] = (1 + 2 * w.lateral) * v[i] + (w.inward + 2 * w.inward_diagonal) * inner +
                (i + 1 < n ? (w.outward + 2 * w.outward_diagonal) * v[i + 1] : 0);
      largest = std::max(largest, next[i]);
    }
    for (std::size_t i = 1; i < n; ++i) v[i] = next[i] / largest;
    const double change = std::abs(largest - 1 - eigenvalue);
    eigenvalue = largest - 1;
    if (change <= 1e-13 * largest) break;
  }
  return eigenvalue;
}

std::vector<RingWeights> ring_weights(const PolarLayout& layout, PolarWeights kind, double kappa) {
  std::vector<RingWeights> weights(static_cast<std::size_t>(layout.rings()));
  if (kind == PolarWeights::finite_volume) {
    finite_volumes(layout, kappa, weights);
    return weights;
  }
  for (int i = 1; i < layout.rings(); ++i)
    weights[static_cast<std::size_t>(i)] =
        kind == PolarWeights::euclidean ? inverse_distance(layout, i) : square(layout, i);
  close(weights);
  // [LM99] beta < 1 / lambda: the slope of the activation function, in whose linear part all but the target lives.
  const double total = largest_eigenvalue(weights) / kStability;
  for (std::size_t i = 1; i < weights.size(); ++i) weights[i].total = total;
  return weights;
}

void finite_volumes(const PolarLayout& layout, double kappa, std::vector<RingWeights>& weights) {
  for (int i = 1; i < layout.rings(); ++i) weights[static_cast<std::size_t>(i)] = volume(layout, i, kappa);
  close(weights);
}

std::vector<RingWeights> ring_weights(const PolarLayout& layout, const OwnWeights& own) {
  std::vector<RingWeights> weights(static_cast<std::size_t>(layout.rings()));
  for (int i = 1; i < layout.rings(); ++i) {
    weights[static_cast<std::size_t>(i)] = own(layout, i);
    check(weights[static_cast<std::size_t>(i)], i);
  }
  close(weights);
  std::vector<RingWeights> gains = weights;
  for (RingWeights& w : gains) {
    for (double* x : {&w.inward, &w.outward, &w.lateral, &w.inward_diagonal, &w.outward_diagonal}) *x /= w.total;
    w.total = 1;
  }
  const double gain = largest_eigenvalue(gains);
  if (!(gain < 1))
    fail(
        "weights: the activation would grow without bounds (largest gain {:.4g}, less than 1 expected); larger totals "
        "make it decay",
        gain);
  return weights;
}

}  // namespace meander
