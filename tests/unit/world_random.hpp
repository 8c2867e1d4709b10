// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <string>

#include "base/error.hpp"
#include "base/random.hpp"
#include "world/editing.hpp"
#include "world/world.hpp"

namespace meander {

// Random worlds for laws: every kind of thing, every kind of shape, awkward numbers and names.

inline Vec2 random_point(Stream& stream, double reach = 20) {
  return {stream.uniform(-reach, reach), stream.uniform(-reach, reach)};
}

inline std::vector<Vec2> random_ring(Stream& stream, const Vec2& center, double radius) {
  std::vector<Vec2> ring;
  const int count = 3 + stream.below(9);
  for (int i = 0; i < count; ++i) {
    const SinCos t = sin_cos(2 * kPi * (i + 0.8 * stream.uniform()) / count);
    ring.push_back(center + radius * stream.uniform(0.5, 1) * Vec2(t.cos, t.sin));
  }
  return ring;
}

inline Shape random_shape(Stream& stream) {
  const Vec2 at = random_point(stream);
  switch (stream.below(4)) {
    case 0: {
      Chain chain{{at}, false};
      for (int i = stream.below(9); i >= 0; --i) chain.points.push_back(chain.points.back() + random_point(stream, 2));
      chain.closed = chain.points.size() > 2 && stream.chance(0.3);
      return chain;
    }
    case 1: {
      Polygon polygon{random_ring(stream, at, 2), {}};
      if (stream.chance(0.3)) polygon.holes.push_back(random_ring(stream, at, 0.3));
      return polygon;
    }
    case 2:
      return Rectangle{at, {stream.uniform(0.05, 3), stream.uniform(0.05, 3)}, stream.uniform(-7, 7)};
    default:
      return Disc{at, stream.uniform(0.01, 1)};
  }
}

inline Surface random_surface(Stream& stream) {
  Surface surface;
  if (stream.chance(0.3)) surface.echo = stream.uniform();
  if (stream.chance(0.3)) surface.specular_limit = stream.uniform(0, kPi / 2);
  return surface;
}

/// Mostly plain names, some with quotes, backslashes, letters beyond ASCII, and some empty.
inline std::string random_name(Stream& stream) {
  static const char* kStems[] = {"",
                                 "crate",
                                 "Stuhl gr\xc3\xbc"
                                 "n",
                                 "a \"quoted\" one",
                                 "back\\slash",
                                 "#[x]",
                                 "\xe6\xa4\x85"};
  const std::string stem = kStems[stream.below(7)];
  return stem.empty() ? stem : stem + " " + std::to_string(stream.below(60));
}

inline Item random_item(Stream& stream) {
  const std::string name = random_name(stream);
  switch (stream.below(7)) {
    case 0:
      return Door{name, random_shape(stream), stream.chance(0.5), random_surface(stream)};
    case 1: {
      Mover mover{
          name, {random_point(stream), stream.uniform(0.1, 0.5)}, {}, {}, stream.uniform(0, 2), stream.chance(0.5)};
      mover.motion = stream.chance(0.5) ? Motion::waypoints : Motion::random_walk;
      for (int i = stream.below(4); i > 0; --i) mover.waypoints.push_back(random_point(stream));
      return mover;
    }
    case 2:
      return Light{name, random_point(stream, 40), stream.uniform(0.01, 10)};
    case 3: {
      Place place{name, random_point(stream), {}, stream.uniform(0.01, 1)};
      if (stream.chance(0.5)) place.heading = stream.uniform(-7, 7);
      return place;
    }
    default:
      return Obstacle{name, random_shape(stream), random_surface(stream)};
  }
}

inline Header random_header(Stream& stream) {
  Header header{
      "title " + std::to_string(stream.below(100)), stream.chance(0.5) ? "one\n\"two\"\\\n\n  three\t" : "", {}, {}};
  header.bounds = {{stream.uniform(-30, -20), stream.uniform(-30, -20)},
                   {stream.uniform(20, 30), stream.uniform(20, 30)}};
  if (stream.chance(0.5)) header.start = Pose2{stream.uniform(-9, 9), stream.uniform(-9, 9), stream.uniform(-7, 7)};
  return header;
}

/// Runs the change; a refusal is fine, the world must then be as it was. Returns whether it was done.
inline bool tried(const std::function<void()>& change) {
  try {
    change();
    return true;
  } catch (const ArgumentError&) {
    return false;
  }
}

inline Id random_id(Stream& stream, const World& world) {
  const std::vector<Id> ids = world.ids();
  return ids[static_cast<std::size_t>(stream.below(static_cast<int>(ids.size())))];
}

/// One random edit, possibly refused.
inline void random_edit(Stream& stream, World& world) {
  const int choice = stream.below(12);
  if (world.size() == 0 || choice < 6) return void(tried([&] { world.add(random_item(stream)); }));
  const Id id = random_id(stream, world);
  tried([&] {
    switch (choice) {
      case 6:
        return world.remove(id);
      case 7:
        return world.set_header(random_header(stream));
      case 8:
        return move(world, {id}, random_point(stream, 1));
      case 9:
        return turn(world, {id, random_id(stream, world)}, stream.uniform(-4, 4));
      case 10:
        return rename(world, id, random_name(stream));
      default:
        return world.replace(id, random_item(stream));
    }
  });
}

inline World random_world(Stream& stream, int edits = 60) {
  World world(random_header(stream));
  for (int i = 0; i < edits; ++i) random_edit(stream, world);
  return world;
}

}  // namespace meander
