// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "sensor/sonar.hpp"
#include "world/world.hpp"

/// The sonar model once more, plainly: loops over everything, rays and the C library's trigonometry. Shares no code
/// with the simulation.
namespace meander::oracle {

inline constexpr double kNone = std::numeric_limits<double>::infinity();

struct Pieces {
  std::vector<Wall> walls;
  std::vector<Pole> poles;
};

inline Pieces pieces_of(const Scene& scene) {
  Pieces p;
  scene.walls().gather({0, 0}, 1e6, p.walls, p.poles);
  p.poles.insert(p.poles.end(), scene.moving.begin(), scene.moving.end());
  return p;
}

struct Hit {
  double range = kNone;
  double incidence = 0;
  int wall = -1;  ///< or -1
};

inline Hit cast(const Pieces& pieces, const Vec2& o, const Vec2& u, double beyond = 0) {
  Hit hit;
  for (std::size_t i = 0; i < pieces.walls.size(); ++i) {
    const Vec2 a = pieces.walls[i].a - o, d = pieces.walls[i].b - pieces.walls[i].a;
    const double along = u.x() * d.y() - u.y() * d.x();
    if (along == 0) continue;
    const double range = (a.x() * d.y() - a.y() * d.x()) / along, t = (a.x() * u.y() - a.y() * u.x()) / along;
    if (t < 0 || t > 1 || range <= beyond || range >= hit.range) continue;
    hit = {range, std::acos(std::min(1.0, std::abs(along) / std::hypot(d.x(), d.y()))), static_cast<int>(i)};
  }
  for (const Pole& pole : pieces.poles) {
    const Vec2 c = pole.disc.center - o;
    const double along = c.dot(u), aside = u.x() * c.y() - u.y() * c.x(), r = pole.disc.radius;
    if (std::abs(aside) > r) continue;
    const double range = along - std::sqrt(r * r - aside * aside);
    if (range <= beyond || range >= hit.range) continue;
    hit = {range, std::asin(std::abs(aside) / r), -1};
  }
  return hit;
}

/// Where a transducer of the ring stands and looks.
struct Look {
  Vec2 origin;
  double axis;
};
inline Look look(const Pose2& pose, const RingLayout& layout, int i) {
  const double axis = pose.heading + layout.first + 2 * std::acos(-1.0) * i / layout.count;
  return {{pose.x + layout.radius * std::cos(axis), pose.y + layout.radius * std::sin(axis)}, axis};
}

inline bool answers(const SonarOptions& o, double range, double incidence) {
  return range <= o.range_max && (!o.incidence || incidence <= o.incidence_limit || range <= o.near_field);
}

/// Walls and discs by a bundle of rays.
inline double bundle(const Pieces& pieces, const Look& look, const SonarOptions& o, int rays, double least = -1,
                     double most = 1) {
  double best = o.range_max;
  for (int i = 0; i < rays; ++i) {
    const double share = rays > 1 ? least + (most - least) * i / (rays - 1) : 0.5 * (least + most);
    const double angle = look.axis + o.half_cone * share;
    const Hit hit = cast(pieces, look.origin, {std::cos(angle), std::sin(angle)});
    if (answers(o, hit.range, hit.incidence)) best = std::min(best, hit.range);
  }
  return best;
}

inline double angle_to(const Look& look, const Vec2& p) {
  const Vec2 d = p - look.origin;
  return std::remainder(std::atan2(d.y(), d.x()) - look.axis, 2 * std::acos(-1.0));
}

/// Does nothing stand between p and q? Things that touch either are let through.
inline bool free_between(const Pieces& pieces, const Vec2& p, const Vec2& q) {
  const Vec2 d = q - p;
  const double length = std::hypot(d.x(), d.y());
  return length < 2e-9 || cast(pieces, p, d / length, 1e-9).range >= length - 1e-9;
}

/// The nearest convex corner that is seen within the cone.
inline double nearest_corner(const Pieces& pieces, const Look& look, const SonarOptions& o) {
  double best = o.range_max;
  for (const Wall& wall : pieces.walls)
    for (const auto& [corner, convex] : {std::pair{wall.a, wall.convex_a}, std::pair{wall.b, wall.convex_b}}) {
      const double range = std::hypot(corner.x() - look.origin.x(), corner.y() - look.origin.y());
      if (!convex || range > o.corner_range || range >= best || std::abs(angle_to(look, corner)) > o.half_cone)
        continue;
      if (free_between(pieces, look.origin, corner)) best = range;
    }
  return best;
}

/// Everything but noise and outliers, without corners: the cone alone.
inline SonarOptions plain_options() {
  SonarOptions o;
  o.range_min = 0;
  o.incidence = false;
  o.near_field = 0;
  o.corner_range = 0;
  o.noise = 0;
  o.noise_proportional = 0;
  o.firing = Firing::simultaneous;
  return o;
}

inline Obstacle obstacle(Shape shape, Surface surface = {}) {
  return {.name = {}, .shape = std::move(shape), .surface = surface};
}

/// Boxes at random headings, thin walls and poles around the origin, none within `clear` of it.
inline World clutter(Stream& random, int things, double half_size, double clear) {
  World world;
  for (int i = 0; i < things; ++i) {
    const Vec2 p(random.uniform(-half_size, half_size), random.uniform(-half_size, half_size));
    const double turn = random.uniform(-3, 3);
    Shape shape;
    switch (random.below(4)) {
      case 0:
        shape = Disc{p, random.uniform(0.01, 0.4)};
        break;
      case 1:
        shape = turned(Chain{{p, p + Vec2(random.uniform(0.1, 3), 0), p + Vec2(1, random.uniform(0.2, 2))}, false},
                       turn, p);
        break;
      default:
        shape = Rectangle{p, {random.uniform(0.05, 1.5), random.uniform(0.05, 1.5)}, turn};
    }
    if (distance(shape, {0, 0}) > clear) world.add(obstacle(shape));
  }
  return world;
}

inline std::vector<double> scan(SonarRing& ring, const Scene& scene, const Pose2& pose,
                                std::uint32_t self = SonarRing::kNobody) {
  std::vector<double> ranges(ring.layout().count);
  const std::vector<Pose2> poses(ring.layout().count, pose);
  ring.scan(scene, poses, self, ranges);
  return ranges;
}

}  // namespace meander::oracle
