// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_crosstalk.hpp"

#include <bit>
#include <cmath>

namespace meander::sonar {
namespace {

/// Does a wall or disc stand between p and q? What only touches an end does not.
class FreePath {
 public:
  FreePath(const Vec2& p, const Vec2& q) : p_(p), length_((q - p).norm()), along_((q - p) / length_) {}
  bool blocked_by(const Wall& wall) const {
    const Vec2 a = wall.a - p_, b = wall.b - p_;
    const double side_a = cross(along_, a), side_b = cross(along_, b);
    if ((side_a > 0) == (side_b > 0)) return false;
    const double range = (along_.dot(a) * side_b - along_.dot(b) * side_a) / (side_b - side_a);
    return range > kTouch && range < length_ - kTouch;
  }
  bool blocked_by(const Pole& pole) const {
    const Vec2 c = pole.disc.center - p_;
    return (c - std::clamp(along_.dot(c), 0.0, length_) * along_).norm() < pole.disc.radius - kTouch;
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
  const auto blocks = [&](const auto& pieces, std::uint32_t block, unsigned touched) {
    for (; touched; touched &= touched - 1)
      if (path.blocked_by(pieces[8 * block + std::countr_zero(touched)])) return true;
    return false;
  };
  const Cull cull = list.cull(path.view(), {.low = 0, .high = 0, .normal = {-1, 0}, .offset = -path.length()});
  for (std::uint32_t block = 0; block < list.moving_blocks().size(); ++block)
    if (blocks(list.moving(), block, cull.may_touch(list.moving_blocks()[block]))) return false;
  for (Outward walk(list, (p - list.center()).norm()); !walk.done() && walk.reach() < path.length(); walk.advance()) {
    const auto block = static_cast<std::uint32_t>(walk.block());
    if (walk.at_walls() ? blocks(list.walls(), block, cull.may_touch(list.wall_blocks()[block]))
                        : blocks(list.poles(), block, cull.may_touch(list.pole_blocks()[block])))
      return false;
  }
  return true;
}

bool in_lobe(const View& view, double tangent, const Vec2& p) {
  const Vec2 local = view.local(p);
  return local.x() > 0 && std::abs(local.y()) <= tangent * local.x();
}

/// A wall as a mirror: the side and the place along it of every point.
struct Mirror {
  Vec2 a, along, normal;
  double length;
  explicit Mirror(const Wall& wall) : a(wall.a), along(wall.b - wall.a), length(along.norm()) {
    along /= length;
    normal = left_of(along);
  }
};

/// All that fire together, with their bounding circle.
struct Group {
  const Candidates& list;
  const Lobes& lobes;
  std::span<Ear> ears;
  Vec2 center{0, 0};
  double radius = 0;
  double farthest = 0;  ///< longest range of all

  Group(const Candidates& candidates, const Lobes& l, std::span<Ear> e) : list(candidates), lobes(l), ears(e) {
    for (const Ear& ear : ears) center += ear.view.origin / static_cast<double>(ears.size());
    for (const Ear& ear : ears) {
      radius = std::max(radius, (ear.view.origin - center).norm());
      farthest = std::max(farthest, ear.range);
    }
  }

  /// Can the wall mirror the sender's sound to anybody? (Necessary, not sufficient.)
  bool may_reach(const Ear& sender, const Mirror& mirror) const {
    const Vec2 image = center - 2 * mirror.normal.dot(center - mirror.a) * mirror.normal;
    const Vec2 p = sender.view.local(image);
    const double tangent = lobes.sent.high, margin = radius * std::sqrt(1 + tangent * tangent) + kTouch;
    return std::abs(p.y()) <= tangent * p.x() + margin && p.norm() - radius < 2 * farthest;
  }

  void reach(const Ear& sender, const Mirror& mirror, double strength, Ear& hearer) const {
    const Vec2 from = sender.view.origin - mirror.a, to = hearer.view.origin - mirror.a;
    const double depth_from = mirror.normal.dot(from), depth_to = mirror.normal.dot(to);
    if (depth_from * depth_to <= 0) return;
    const double u = mirror.along.dot(from), v = mirror.along.dot(to);
    const double range = 0.5 * std::sqrt((u - v) * (u - v) + (depth_from + depth_to) * (depth_from + depth_to));
    if (!(range < hearer.range) || range > strength * lobes.range) return;
    const double place = u + (v - u) * (depth_from / (depth_from + depth_to));
    if (place < 0 || place > mirror.length) return;
    const Vec2 p = mirror.a + place * mirror.along;
    if (!in_lobe(sender.view, lobes.sent.high, p) || !in_lobe(hearer.view, lobes.receive, p)) return;
    if (free_between(list, sender.view.origin, p) && free_between(list, hearer.view.origin, p)) hearer.range = range;
  }
};

}  // namespace

void hear_each_other(const Candidates& list, std::span<const Reflector> reflectors, const Lobes& lobes,
                     std::span<Ear> ears) {
  const Group group(list, lobes, ears);
  for (const Ear& sender : ears) {
    // The way to the wall is at most half the whole way and half the way between the two.
    const double most = group.farthest + group.radius, shift = (sender.view.origin - list.center()).norm();
    const Cull cull = list.cull(sender.view, lobes.sent);
    for (std::uint32_t block = 0; block < list.wall_blocks().size(); ++block) {
      if (list.wall_block_distance(block) - shift >= most) break;
      for (unsigned touched = cull.may_touch(list.wall_blocks()[block]); touched; touched &= touched - 1) {
        const Wall& wall = list.walls()[8 * block + std::countr_zero(touched)];
        const Mirror mirror(wall);
        if (!group.may_reach(sender, mirror)) continue;
        for (Ear& hearer : ears)
          if (&hearer != &sender) group.reach(sender, mirror, reflectors[wall.material].strength, hearer);
      }
    }
  }
}

}  // namespace meander::sonar
