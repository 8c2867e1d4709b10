// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/editing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/error.hpp"
#include "world/text.hpp"
#include "world/validity.hpp"

namespace meander {
namespace {

/// A change of whole things, given as what it does to shapes, to points and to headings.
struct Change {
  std::function<Shape(const Shape&)> on_shape;
  std::function<Vec2(const Vec2&)> on_point;
  double turn = 0;

  void operator()(Obstacle& obstacle) const { obstacle.shape = on_shape(obstacle.shape); }
  void operator()(Door& door) const { door.shape = on_shape(door.shape); }
  void operator()(Mover& mover) const {
    mover.disc = std::get<Disc>(on_shape(Shape(mover.disc)));
    for (Vec2& p : mover.waypoints) p = on_point(p);
  }
  void operator()(Light& light) const { light.position = on_point(light.position); }
  void operator()(Place& place) const {
    place.position = on_point(place.position);
    if (place.heading) *place.heading = wrap_angle(*place.heading + turn);
  }
};

void change_all(World& world, const std::vector<Id>& ids, const Change& change) {
  const auto replace_all = [&] {
    for (const Id id : ids) {
      Item item = world.item(id);
      std::visit(change, item);
      world.replace(id, std::move(item));
    }
  };
  // A single thing is checked before anything changes, so that a refusal leaves no trace in the log.
  if (ids.size() == 1)
    replace_all();
  else
    world.transaction(replace_all);
}

Box box_of(const Item& item) {
  if (const auto* obstacle = std::get_if<Obstacle>(&item)) return bounding_box(obstacle->shape);
  if (const auto* door = std::get_if<Door>(&item)) return bounding_box(door->shape);
  if (const auto* mover = std::get_if<Mover>(&item)) return bounding_box(mover->disc);
  const auto* light = std::get_if<Light>(&item);
  const Vec2 position = light ? light->position : std::get<Place>(item).position;
  return {position, position};
}

double nearest_line(double value, double step) { return std::round(value / step) * step; }

Vec2 nearest_crossing(const Vec2& p, double step) { return {nearest_line(p.x(), step), nearest_line(p.y(), step)}; }

void snap_points(std::vector<Vec2>& points, double step) {
  for (Vec2& p : points) p = nearest_crossing(p, step);
}

Shape snapped(Shape shape, double step) {
  if (auto* chain = std::get_if<Chain>(&shape)) {
    snap_points(chain->points, step);
  } else if (auto* polygon = std::get_if<Polygon>(&shape)) {
    snap_points(polygon->outer, step);
    for (auto& hole : polygon->holes) snap_points(hole, step);
  } else {
    return moved(shape, nearest_crossing(center(shape), step) - center(shape));
  }
  return shape;
}

}  // namespace

std::vector<Id> matching(const World& world, const std::string& pattern) {
  std::vector<Id> found = world.ids();
  std::erase_if(found, [&](Id id) { return !fits_pattern(name_of(world.item(id)), pattern); });
  return found;
}

Vec2 center_of(const World& world, const std::vector<Id>& ids) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box all{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Id id : ids) {
    const Box box = box_of(world.item(id));
    all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
  }
  return ids.empty() ? Vec2(0, 0) : all.center();
}

void move(World& world, const std::vector<Id>& ids, const Vec2& by) {
  change_all(
      world, ids,
      Change{[&](const Shape& shape) { return moved(shape, by); }, [&](const Vec2& p) -> Vec2 { return p + by; }});
}

void turn(World& world, const std::vector<Id>& ids, double by, std::optional<Vec2> about) {
  if (!(std::abs(by) <= kLargestHeading))
    fail("turn: an angle within +-{:g} rad expected, got {}", kLargestHeading, by);
  const Vec2 pivot = about.value_or(center_of(world, ids));
  const Pose2 rotation{0, 0, by};
  change_all(world, ids,
             Change{[&](const Shape& shape) { return turned(shape, by, pivot); },
                    [&](const Vec2& p) -> Vec2 { return pivot + rotation * Vec2(p - pivot); }, by});
}

void scale(World& world, const std::vector<Id>& ids, double factor, std::optional<Vec2> about) {
  if (!(factor > 0) || !std::isfinite(factor)) fail("scale: factor above 0 expected, got {}", factor);
  const Vec2 pivot = about.value_or(center_of(world, ids));
  change_all(world, ids,
             Change{[&](const Shape& shape) { return scaled(shape, factor, pivot); },
                    [&](const Vec2& p) -> Vec2 { return pivot + factor * (p - pivot); }});
}

void snap(World& world, const std::vector<Id>& ids, double step) {
  if (!(step >= kShortest && step <= kFarthest))
    fail("snap: step from {} to {} m expected, got {}", kShortest, kFarthest, step);
  change_all(world, ids,
             Change{[&](const Shape& shape) { return snapped(shape, step); },
                    [&](const Vec2& p) { return nearest_crossing(p, step); }});
}

void rename(World& world, Id id, const std::string& name) {
  Item item = world.item(id);
  if (name.empty()) fail("name: 1 to {} characters expected, got none", kLongestName);
  std::visit([&](auto& thing) { thing.name = name; }, item);
  world.replace(id, std::move(item));
}

void set_open(World& world, Id door, bool open) {
  Item item = world.item(door);
  auto* leaf = std::get_if<Door>(&item);
  if (!leaf) fail("{} is no door", label(item));
  leaf->open = open;
  world.replace(door, std::move(item));
}

}  // namespace meander
