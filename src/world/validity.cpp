// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/validity.hpp"

#include <cmath>

#include "base/error.hpp"
#include "world/text.hpp"

namespace meander {
namespace {

void check_number(double value, const char* what, double least, double most) {
  if (!(value >= least && value <= most)) fail("{}: number from {} to {} expected, got {}", what, least, most, value);
}

void check_positive(double value, const char* what, double most) {
  if (!(value > 0 && value <= most)) fail("{}: number above 0 up to {} expected, got {}", what, most, value);
}

void check_point(const Vec2& p, const char* what) {
  if (!(p.cwiseAbs().maxCoeff() <= kFarthest) || !p.allFinite())
    fail("{}: coordinates from {} to {} expected, got ({}, {})", what, -kFarthest, kFarthest, p.x(), p.y());
}

void check_heading(double heading) { check_number(heading, "heading", -kLargestHeading, kLargestHeading); }

void check_shape(const Shape& shape) {
  if (const auto reason = invalid(shape)) fail("{}", *reason);
}

void check_surface(const Surface& surface) {
  check_number(surface.echo, "echo", 0, 1);
  if (surface.specular_limit) check_number(*surface.specular_limit, "specular_limit", 0, kPi / 2);
}

void check_thing(const Obstacle& obstacle) {
  check_shape(obstacle.shape);
  check_surface(obstacle.surface);
}
void check_thing(const Door& door) {
  check_shape(door.shape);
  check_surface(door.surface);
}
void check_thing(const Mover& mover) {
  check_shape(mover.disc);
  for (const Vec2& p : mover.waypoints) check_point(p, "waypoints");
  check_number(mover.speed, "speed", 0, kLargestNumber);
}
void check_thing(const Light& light) {
  check_point(light.position, "position");
  check_positive(light.strength, "strength", kLargestNumber);
}
void check_thing(const Place& place) {
  check_point(place.position, "position");
  if (place.heading) check_heading(*place.heading);
  check_positive(place.tolerance, "tolerance", kFarthest);
}

void check_name(const std::string& name) {
  const auto length = text_length(name);
  if (!length || *length == 0 || *length > kLongestName || has_control(name, ""))
    fail("name: 1 to {} characters without control characters expected, got '{}'", kLongestName, printable(name));
}

/// Negative zero becomes zero; everything else stays.
double plain(double value) { return value + 0.0; }
Vec2 plain(const Vec2& p) { return {plain(p.x()), plain(p.y())}; }
void make_plain(std::vector<Vec2>& points) {
  for (Vec2& p : points) p = plain(p);
}
double plain_heading(double heading) {
  return std::abs(heading) <= kLargestHeading ? plain(wrap_angle(heading)) : heading;
}

void make_plain(Chain& chain) { make_plain(chain.points); }
void make_plain(Polygon& polygon) {
  make_plain(polygon.outer);
  for (auto& hole : polygon.holes) make_plain(hole);
}
void make_plain(Rectangle& r) { r = {plain(r.center), plain(r.size), plain_heading(r.heading)}; }
void make_plain(Disc& disc) { disc = {plain(disc.center), plain(disc.radius)}; }
void make_plain(Shape& shape) {
  shape = canonical(std::move(shape));
  std::visit([](auto& s) { make_plain(s); }, shape);
}

void make_plain(Surface& surface) {
  surface.echo = plain(surface.echo);
  if (surface.specular_limit) *surface.specular_limit = plain(*surface.specular_limit);
}
template <class Solid>
requires requires(Solid& s) { s.shape; }
void make_plain(Solid& solid) {
  make_plain(solid.shape);
  make_plain(solid.surface);
}
void make_plain(Mover& mover) {
  make_plain(mover.disc);
  make_plain(mover.waypoints);
  mover.speed = plain(mover.speed);
}
void make_plain(Light& light) { light.position = plain(light.position); }
void make_plain(Place& place) {
  place.position = plain(place.position);
  if (place.heading) *place.heading = plain_heading(*place.heading);
}

}  // namespace

std::string label(const Item& item) { return fmt::format("{} '{}'", kind_of(item), printable(name_of(item))); }

std::string point_text(const Vec2& p) { return fmt::format("({:.4g}, {:.4g})", p.x(), p.y()); }

void check_item(const Item& item) {
  check_name(name_of(item));
  try {
    std::visit([](const auto& thing) { check_thing(thing); }, item);
  } catch (const ArgumentError& error) {
    fail("{}: {}", label(item), error.what());
  }
}

void check_header(const Header& header) {
  check_point(header.bounds.low, "bounds");
  check_point(header.bounds.high, "bounds");
  if (!((header.bounds.size().array() > 0).all()))
    fail("bounds: {{low x, low y}}, {{high x, high y}} with low < high expected, got {} to {}",
         point_text(header.bounds.low), point_text(header.bounds.high));
  if (header.start) {
    check_point(header.start->position(), "start");
    check_heading(header.start->heading);
  }
  const auto title = text_length(header.title), note = text_length(header.note);
  if (!title || *title > 2 * kLongestName || has_control(header.title, ""))
    fail("title: one line of up to {} characters expected, got '{}'", 2 * kLongestName, printable(header.title));
  if (!note || *note > kLongestNote || has_control(header.note, "\n\t"))
    fail("note: up to {} characters without control characters expected", kLongestNote);
}

Item normalised(Item item) {
  std::visit([](auto& thing) { make_plain(thing); }, item);
  return item;
}

Header normalised(Header header) {
  header.bounds = {plain(header.bounds.low), plain(header.bounds.high)};
  if (auto& s = header.start) s = Pose2{plain(s->x), plain(s->y), plain_heading(s->heading)};
  return header;
}

}  // namespace meander
