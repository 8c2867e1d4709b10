// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/trail.hpp"

#include <algorithm>

namespace meander::topology {
namespace {

/// What a stretch counts where the map has no place [squared distance].
constexpr double kNowhere = 4;
/// Another place must fit better than where the robot believes to be: at most this share of the mismatch there.
constexpr double kBetter = 0.7;

}  // namespace

Trail::Trail(int length, double spacing, int stride)
    : length_(length),
      spacing_(spacing),
      stride_(static_cast<std::size_t>(stride)),
      positions_(static_cast<std::size_t>(length), Vec2(0, 0)),
      senses_(static_cast<std::size_t>(length) * stride_) {}

void Trail::add(const Situation& situation) {
  if (count_ > 0 && (positions_[slot(count_ - 1)] - situation.position).norm() < spacing_) return;
  if (count_ == length_)
    first_ = (first_ + 1) % length_;
  else
    ++count_;
  const std::size_t last = slot(count_ - 1);
  positions_[last] = situation.position;
  std::copy_n(situation.senses, stride_, senses_.begin() + static_cast<std::ptrdiff_t>(last * stride_));
}

double Trail::mismatch(const GrowingNet& net, const Vec2& shift, double spread, double limit) const {
  double sum = 0;
  for (int i = count_ - 1; i >= 0 && sum <= limit; --i) {
    const Vec2 there = positions_[slot(i)] + shift;
    double best = kNowhere;
    net.around(there, spread, [&](int cell) {
      if ((net.cells()[cell].position - there).squaredNorm() > spread * spread) return;
      best = std::min(best, net.metric().squared(net.cells().senses(cell), senses(i)));
    });
    sum += best;
  }
  return sum;
}

std::optional<Trail::Place> Trail::find(const GrowingNet& net, double spread) const {
  if (2 * count_ < length_) return std::nullopt;
  const Vec2 here = positions_[slot(count_ - 1)];
  Place place;
  double best = kBetter * mismatch(net, {0, 0}, spread, kNowhere * count_);
  bool found = false;
  for (int cell = 0; cell < net.cells().slots(); ++cell) {
    if (!net.cells()[cell].alive()) continue;
    const double sum = mismatch(net, net.cells()[cell].position - here, spread, best);
    if (sum >= best) continue;
    best = sum;
    found = true;
    place = {net.cells()[cell].position, sum / count_};
  }
  return found ? std::optional(place) : std::nullopt;
}

}  // namespace meander::topology
