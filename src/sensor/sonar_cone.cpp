// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_cone.hpp"

#include <algorithm>

namespace meander::sonar {

double Cone::first_echo(const Candidates& list, const View& view, const Wedge& wedge, const Hearing& hearing,
                        std::span<const Reflector> reflectors, double shift, double most) {
  in_wedge_.start(view, wedge, hearing, reflectors);
  best_ = bound_ = most;
  next_ = kNever;
  covered_ = heard_ = 0;
  cover_low_ = wedge.low, cover_high_ = wedge.high, cover_far_ = 0;

  const Cull cull = list.cull(view, wedge);
  look_nearby(list, cull, std::min(most, hearing.corner_range) + shift);
  for (Outward walk(list, shift); walk.reach() < bound_; walk.advance()) {
    settle_within(walk.reach());
    if (walk.reach() < bound_) look_at(list, cull, walk);
  }
  settle_within(kNever);
  return best_;
}

/// What is not sorted or not far: moving discs and corners.
void Cone::look_nearby(const Candidates& list, const Cull& cull, double corner_distance) {
  for (std::size_t block = 0; block < list.moving().blocks.size(); ++block)
    list.moving().visit_touched(block, cull,
                                [&](const Pole& pole, std::uint32_t i) { in_wedge_.add(pole, i, bound_); });
  for (std::size_t block = 0; list.corners().distance_from(block) <= corner_distance; ++block)
    list.corners().visit_touched(block, cull,
                                 [&](const Corner& corner, std::uint32_t) { in_wedge_.add(corner, bound_); });
  cover();
}

void Cone::look_at(const Candidates& list, const Cull& cull, const Outward& walk) {
  if (walk.at_faces())
    list.faces().visit_touched(walk.block(), cull,
                               [&](const Face& face, std::uint32_t i) { in_wedge_.add(face, i, bound_); });
  else
    list.poles().visit_touched(walk.block(), cull,
                               [&](const Pole& pole, std::uint32_t i) { in_wedge_.add(pole, i, bound_); });
  cover();
}

/// Once pieces that reach in from both borders meet, nothing behind them can be heard.
void Cone::cover() {
  for (; covered_ < in_wedge_.pieces.size() && cover_low_ < cover_high_; ++covered_) {
    const Piece& piece = in_wedge_.pieces[covered_];
    const bool from_low = piece.low <= cover_low_ && piece.high > cover_low_;
    const bool from_high = piece.high >= cover_high_ && piece.low < cover_high_;
    if (!from_low && !from_high) continue;
    if (from_low) cover_low_ = piece.high;
    if (from_high) cover_high_ = piece.low;
    cover_far_ = std::max({cover_far_, distance_at(piece.low, piece.w_low), distance_at(piece.high, piece.w_high)});
    if (cover_low_ >= cover_high_) bound_ = std::min(bound_, cover_far_);
  }
}

/// Settles the echoes that are complete: everything nearer than `reach` is known.
void Cone::settle_within(double reach) {
  std::vector<Echo>& echoes = in_wedge_.echoes;
  for (; heard_ < echoes.size(); ++heard_) next_ = std::min(next_, echoes[heard_].range);
  while (next_ < std::min(best_, reach)) {
    Echo& first =
        *std::min_element(echoes.begin(), echoes.end(), [](const Echo& a, const Echo& b) { return a.range < b.range; });
    settle(first, in_wedge_.pieces, reach, shadows_);
    if (first.range < reach) {
      best_ = std::min(best_, first.range);
      bound_ = std::min(bound_, best_);
      first.range = kNever;
    }
    next_ = kNever;
    for (const Echo& echo : echoes) next_ = std::min(next_, echo.range);
  }
}

}  // namespace meander::sonar
