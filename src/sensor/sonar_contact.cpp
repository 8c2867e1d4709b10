// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/sonar_contact.hpp"

namespace meander::sonar {
namespace {

bool apart(double side_a, double side_b) { return (side_a > 0 && side_b > 0) || (side_a < 0 && side_b < 0); }

/// Does the wall come within touching distance of the leg p-q?
bool meets(const Face& wall, const Vec2& p, const Vec2& q) {
  const Vec2 leg = q - p, along = wall.b - wall.a;
  const bool crossed = !apart(cross(leg, wall.a - p), cross(leg, wall.b - p)) &&
                       !apart(cross(along, p - wall.a), cross(along, q - wall.a)) && cross(leg, along) != 0;
  return crossed || distance_to_segment(p, wall.a, wall.b) <= kContact ||
         distance_to_segment(q, wall.a, wall.b) <= kContact || distance_to_segment(wall.a, p, q) <= kContact ||
         distance_to_segment(wall.b, p, q) <= kContact;
}

bool meets(const Pole& pole, const Vec2& p, const Vec2& q) {
  const Vec2 leg = q - p, e = pole.disc.center - p;
  const double length_squared = leg.squaredNorm();
  const double t = length_squared > 0 ? std::clamp(e.dot(leg) / length_squared, 0.0, 1.0) : 0;
  return (e - t * leg).norm() <= pole.disc.radius + kContact;
}

}  // namespace

void Contact::look_around(const ShapeIndex& index, const Candidates& list, const Vec2& center) {
  place_ = center;
  inside_ = index.inside(center);
  double nearest = list.radius();
  for (Outward walk(list, (center - list.center()).norm()); walk.reach() < nearest; walk.advance()) {
    if (walk.at_faces())
      list.faces().visit_all(walk.block(), [&](const Face& face) {
        nearest = std::min(nearest, distance_to_segment(center, face.a, face.b));
      });
    else
      list.poles().visit_all(walk.block(), [&](const Pole& pole) {
        nearest = std::min(nearest, (pole.disc.center - center).norm() - pole.disc.radius);
      });
  }
  free_radius_ = nearest;
}

bool Contact::operator()(const ShapeIndex& index, const Candidates& list, const Vec2& center, const Vec2& transducer) {
  for (const Pole& pole : list.moving().things)
    if (meets(pole, center, transducer)) return true;
  const double leg = (transducer - center).norm();
  if ((center - place_).norm() + leg + kContact < free_radius_) return inside_;

  look_around(index, list, center);
  if (inside_) return true;
  if (leg + kContact < free_radius_) return false;
  bool met = false;
  const auto meet = [&](const auto& thing) { met = met || meets(thing, center, transducer); };
  for (Outward walk(list, (center - list.center()).norm()); !met && walk.reach() <= leg + kContact; walk.advance())
    walk.at_faces() ? list.faces().visit_all(walk.block(), meet) : list.poles().visit_all(walk.block(), meet);
  return met;
}

}  // namespace meander::sonar
