// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_cone.hpp"

#include <algorithm>

namespace meander::sonar {
namespace {

bool everything_answers(const Hearing& hearing, std::span<const Reflector> reflectors) {
  return !hearing.incidence && hearing.strength == 1 &&
         std::all_of(reflectors.begin(), reflectors.end(), [](const Reflector& r) { return r.strength == 1; });
}

}  // namespace

double Cone::first_echo(const Candidates& list, const View& view, const Wedge& wedge, const Hearing& hearing,
                        std::span<const Reflector> reflectors, double shift, double most) {
  in_wedge_.start(view, wedge, hearing, reflectors);
  best_ = bound_ = most;
  all_answer_ = everything_answers(hearing, reflectors);
  next_ = kNever;
  covered_ = heard_ = 0;
  cover_low_ = wedge.low, cover_high_ = wedge.high, cover_far_squared_ = 0;

  const Cull cull = list.cull(view, wedge);
  look_at_moving(list, cull);
  for (Outward walk(list, shift); walk.reach() < bound_; walk.advance()) {
    if (lowest_echo() < walk.reach()) settle_within(walk.reach());
    if (walk.reach() < bound_) look_at(list, cull, walk);
  }
  settle_within(kNever);
  return best_;
}

double Cone::nearest() const {
  double nearest = bound_;
  for (const Piece& piece : in_wedge_.pieces) nearest = std::min(nearest, piece.near);
  return nearest;
}

void Cone::look_at_moving(const Candidates& list, const Cull& cull) {
  for (std::size_t block = 0; block < list.moving().blocks.size(); ++block)
    for_bits(cull.may_touch(list.moving().blocks[block]), block,
             [&](std::uint32_t i) { in_wedge_.add(list.moving().things[i], i, bound_); });
  cover();
}

void Cone::look_at(const Candidates& list, const Cull& cull, const Outward& walk) {
  const std::size_t block = walk.block();
  if (walk.at_faces()) {
    const std::vector<Face>& faces = list.faces().things;
    const WallBlock& walls = list.faces().blocks[block];
    const Touched touched = cull.may_touch(walls);
    for_bits(touched.walls, block, [&](std::uint32_t i) {
      in_wedge_.add(faces[i], i, bound_);
      // The nearest point of all is visible by itself: where everything answers, no echo needs to be settled.
      if (all_answer_) bound_ = best_ = std::min(best_, lowest_echo());
    });
    if (walk.reach() < in_wedge_.hearing.corner_range) {
      const auto& corner = [&](const Vec2& at, const Face& face) { in_wedge_.add_corner(at, face.kind, bound_); };
      for_bits(touched.a & walls.convex_a, block, [&](std::uint32_t i) { corner(faces[i].a, faces[i]); });
      for_bits(touched.b & walls.convex_b, block, [&](std::uint32_t i) { corner(faces[i].b, faces[i]); });
    }
  } else {
    for_bits(cull.may_touch(list.poles().blocks[block]), block,
             [&](std::uint32_t i) { in_wedge_.add(list.poles().things[i], i, bound_); });
  }
  if (covered_ < in_wedge_.pieces.size()) cover();
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
    cover_far_squared_ = std::max(cover_far_squared_, piece.far_squared);
    if (cover_low_ >= cover_high_) bound_ = std::min(bound_, std::sqrt(cover_far_squared_));
  }
}

/// Least range of the echoes not yet settled.
double Cone::lowest_echo() {
  for (; heard_ < in_wedge_.echoes.size(); ++heard_) next_ = std::min(next_, in_wedge_.echoes[heard_].range);
  return next_;
}

/// Settles the echoes that are complete: everything nearer than `reach` is known.
void Cone::settle_within(double reach) {
  std::vector<Echo>& echoes = in_wedge_.echoes;
  while (lowest_echo() < std::min(best_, reach)) {
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
