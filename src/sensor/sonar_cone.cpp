// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_cone.hpp"

#include <algorithm>
#include <bit>

namespace meander::sonar {

double Cone::first_echo(const Candidates& list, const View& view, const Wedge& wedge, const Hearing& hearing,
                        std::span<const Reflector> reflectors, double shift, double most) {
  in_wedge_.start(view, wedge, hearing, reflectors);
  best_ = bound_ = most;
  next_ = kNever;
  covered_ = heard_ = 0;
  cover_low_ = wedge.low, cover_high_ = wedge.high, cover_far_ = 0;

  const Cull cull = list.cull(view, wedge);
  look_at_moving(list, cull);
  for (Outward walk(list, shift); !walk.done() && walk.reach() < bound_; walk.advance()) {
    settle_within(walk.reach());
    if (walk.reach() < bound_) look_at(list, cull, walk);
  }
  settle_within(kNever);
  return best_;
}

void Cone::look_at(const Candidates& list, const Cull& cull, const Outward& walk) {
  const auto block = static_cast<std::uint32_t>(walk.block());
  if (walk.at_walls()) {
    for (unsigned left = cull.may_touch(list.wall_blocks()[block]); left; left &= left - 1) {
      const std::uint32_t i = 8 * block + std::countr_zero(left);
      in_wedge_.add(list.walls()[i], i, bound_);
    }
  } else {
    for (unsigned left = cull.may_touch(list.pole_blocks()[block]); left; left &= left - 1) {
      const std::uint32_t i = 8 * block + std::countr_zero(left);
      in_wedge_.add(list.poles()[i], i, bound_);
    }
  }
  cover();
}

void Cone::look_at_moving(const Candidates& list, const Cull& cull) {
  for (std::uint32_t block = 0; block < list.moving_blocks().size(); ++block)
    for (unsigned left = cull.may_touch(list.moving_blocks()[block]); left; left &= left - 1) {
      const std::uint32_t i = 8 * block + std::countr_zero(left);
      in_wedge_.add(list.moving()[i], i, bound_);
    }
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
