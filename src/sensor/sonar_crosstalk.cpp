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
  bool may_reach(const Ear& sender, const Face& wall) const {
    const double side = cross(wall.along, sender.view.origin - wall.a), depth = cross(wall.along, center - wall.a);
    if (wall.solid && side >= 0) return false;  // seen from within
    const Vec2 image = sender.view.local(center - 2 * depth * left_of(wall.along));
    const double tangent = lobes.sent.high, margin = radius * std::sqrt(1 + tangent * tangent) + kTouch;
    return std::abs(image.y()) <= tangent * image.x() + margin && image.norm() - radius < 2 * farthest;
  }

  void reach(const Ear& sender, const Face& wall, double strength, Ear& hearer) const {
    const Vec2 from = sender.view.origin - wall.a, to = hearer.view.origin - wall.a;
    const double depth_from = cross(wall.along, from), depth_to = cross(wall.along, to);
    if (depth_from * depth_to <= 0) return;
    const double u = wall.along.dot(from), v = wall.along.dot(to), depths = depth_from + depth_to;
    const double range = 0.5 * std::sqrt((u - v) * (u - v) + depths * depths);
    if (!(range < hearer.range) || range > strength * lobes.range) return;
    const double place = u + (v - u) * (depth_from / depths);
    if (place < 0 || place > wall.length) return;
    const Vec2 p = wall.a + place * wall.along;
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
    const double most = group.farthest + group.radius + (sender.view.origin - list.center()).norm();
    const Cull cull = list.cull(sender.view, lobes.sent);
    for (std::size_t block = 0; list.faces().distance[block] < most; ++block)
      for_bits(cull.may_touch(list.faces().blocks[block]).walls, block, [&](std::uint32_t i) {
        const Face& wall = list.faces().things[i];
        if (!group.may_reach(sender, wall)) return;
        for (Ear& hearer : ears)
          if (&hearer != &sender) group.reach(sender, wall, reflectors[wall.kind].strength, hearer);
      });
  }
}

}  // namespace meander::sonar
