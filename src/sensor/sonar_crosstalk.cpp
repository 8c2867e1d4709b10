// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_crosstalk.hpp"

#include <cmath>

namespace meander::sonar {
namespace {

/// Does a wall or disc stand between p and q? What only touches an end does not.
class FreePath {
 public:
  FreePath(const Vec2& p, const Vec2& q) : p_(p), length_((q - p).norm()), along_((q - p) / length_) {}
  bool blocked_by(const Face& wall) const {
    const Vec2 a = wall.a - p_, b = wall.b - p_;
    const double side_a = cross(along_, a), side_b = cross(along_, b);
    if ((side_a > 0) == (side_b > 0)) return false;
    const double range = (along_.dot(a) * side_b - along_.dot(b) * side_a) / (side_b - side_a);
    return range > kContact && range < length_ - kContact;
  }
  bool blocked_by(const Pole& pole) const {
    const Vec2 c = pole.disc.center - p_;
    return (c - std::clamp(along_.dot(c), 0.0, length_) * along_).norm() < pole.disc.radius - kContact;
  }
  /// A wedge that holds the path: a narrow one.
  View view() const { return {p_, along_, left_of(along_)}; }
  double length() const { return length_; }

 private:
  Vec2 p_;
  double length_;
  Vec2 along_;
};

bool free_between(const Candidates& list, const Vec2& p, const Vec2& q) {
  const FreePath path(p, q);
  bool blocked = false;
  const auto test = [&](const auto& things, unsigned touched, std::size_t block) {
    for_bits(touched, block, [&](std::uint32_t i) { blocked = blocked || path.blocked_by(things[i]); });
  };
  const Cull cull = list.cull(path.view(), {.low = 0, .high = 0, .normal = {-1, 0}, .offset = -path.length()});
  for (std::size_t block = 0; block < list.moving().blocks.size(); ++block)
    test(list.moving().things, cull.may_touch(list.moving().blocks[block]), block);
  for (Outward walk(list, (p - list.center()).norm()); !blocked && walk.reach() < path.length(); walk.advance()) {
    const std::size_t block = walk.block();
    if (walk.at_faces())
      test(list.faces().things, cull.may_touch(list.faces().blocks[block]).walls, block);
    else
      test(list.poles().things, cull.may_touch(list.poles().blocks[block]), block);
  }
  return !blocked;
}

bool in_lobe(const View& view, double tangent, const Vec2& p) {
  const Vec2 local = view.local(p);
  return local.x() > 0 && std::abs(local.y()) <= tangent * local.x();
}

/// The sum of both half angles.
SinCos opening(const Lobes& lobes) {
  const double length = std::sqrt(1 + lobes.sent.high * lobes.sent.high);
  const SinCos sent{lobes.sent.high / length, 1 / length}, &receive = lobes.receive;
  return {sent.sin * receive.cos + sent.cos * receive.sin, sent.cos * receive.cos - sent.sin * receive.sin};
}

/// How far from the sender a place can be that both its cone and the hearer's lobe see [m]: from there the two are seen
/// at least as far apart as their axes are, less both half angles; then the law of sines.
double common_reach(const SinCos& open, const View& sender, const View& hearer, double between) {
  const SinCos apart{std::abs(cross(sender.ahead, hearer.ahead)), sender.ahead.dot(hearer.ahead)};
  const double left_sin = apart.sin * open.cos - apart.cos * open.sin;
  if (left_sin <= 0) return kNever;
  const double left_cos = apart.cos * open.cos + apart.sin * open.sin;
  return left_cos <= 0 ? between : between / left_sin;
}

/// Half the way from the sender over the wall to the hearer, if it is open; kNever otherwise or when not below `most`.
double way_over(const Candidates& list, const Lobes& lobes, const Face& wall, const View& sender, const View& hearer,
                double most) {
  const Vec2 from = sender.origin - wall.a, to = hearer.origin - wall.a;
  const double depth_from = cross(wall.along, from), depth_to = cross(wall.along, to), depths = depth_from + depth_to;
  if (depth_from * depth_to <= 0) return kNever;
  const double u = wall.along.dot(from), v = wall.along.dot(to), whole_squared = (u - v) * (u - v) + depths * depths;
  if (!(whole_squared < 4 * most * most)) return kNever;
  const double place = (u * depth_to + v * depth_from) / depths;
  if (place < 0 || place > wall.length) return kNever;
  const Vec2 p = wall.a + place * wall.along;
  const bool open = in_lobe(sender, lobes.sent.high, p) && in_lobe(hearer, lobes.receive.sin / lobes.receive.cos, p) &&
                    free_between(list, sender.origin, p) && free_between(list, hearer.origin, p);
  return open ? 0.5 * std::sqrt(whole_squared) : kNever;
}

}  // namespace

/// Returns the largest distance of a wall that matters.
double Crosstalk::find_hearers(const SinCos& open, std::span<Ear> ears, const Ear& sender) {
  hearers_.clear();
  double most = 0;
  for (Ear& ear : ears) {
    if (&ear == &sender) continue;
    // The way to the wall is at most half the whole way and half the way between the two.
    const double between = (ear.view.origin - sender.view.origin).norm();
    const double reach = std::min(common_reach(open, sender.view, ear.view, between), ear.range + between / 2);
    if (reach + kContact < sender.nearest) continue;
    hearers_.push_back({&ear, reach + kContact});
    most = std::max(most, reach + kContact);
  }
  return most;
}

void Crosstalk::hear_each_other(const Candidates& list, std::span<const Reflector> reflectors, const Lobes& lobes,
                                std::span<Ear> ears) {
  const SinCos open = opening(lobes);
  for (const Ear& sender : ears) {
    const double most = find_hearers(open, ears, sender), shift = (sender.view.origin - list.center()).norm();
    if (hearers_.empty()) continue;
    const Cull cull = list.cull(sender.view, lobes.sent);
    const auto over = [&](const Face& wall) {
      const double depth = cross(wall.along, sender.view.origin - wall.a);
      if (wall.solid && depth >= 0) return;  // seen from within
      for (const auto& [ear, reach] : hearers_) {
        if (std::abs(depth) > reach) continue;
        const double loud = std::min(ear->range, reflectors[wall.kind].strength * lobes.range);
        ear->range = std::min(ear->range, way_over(list, lobes, wall, sender.view, ear->view, loud));
      }
    };
    for (std::size_t block = 0; list.faces().distance[block] - shift < most; ++block)
      for_bits(cull.may_touch(list.faces().blocks[block]).walls, block,
               [&](std::uint32_t i) { over(list.faces().things[i]); });
  }
}

}  // namespace meander::sonar
