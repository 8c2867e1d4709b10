// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/validity.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"
#include "world/editing.hpp"
#include "world/world.hpp"

namespace meander {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Why the world refuses the change; it must then be as it was.
std::string refusal(World& world, const std::function<void()>& change) {
  const World before = world;
  try {
    change();
  } catch (const ArgumentError& error) {
    EXPECT_TRUE(world == before);
    EXPECT_EQ(world.revision(), before.revision());
    return error.what();
  }
  return "nothing was refused";
}

std::string refusal(const Item& item) {
  World world(Header{"", "", {{0, 0}, {10, 10}}, Pose2{1, 1, 0}});
  return refusal(world, [&] { world.add(item); });
}

std::string refusal(const Header& header) {
  World world;
  return refusal(world, [&] { world.set_header(header); });
}

bool starts(const std::string& text, const std::string& prefix) { return text.rfind(prefix, 0) == 0; }

const Shape kBox = Rectangle{{5, 5}, {1, 1}, 0};
const Disc kPerson{{5, 5}, 0.2};

TEST(WorldValidity, ShapesAreJudgedByGeometry) {
  const std::string message = refusal(Obstacle{"bow", Polygon{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}, {}});
  EXPECT_TRUE(starts(message, "obstacle 'bow': ")) << message;
  EXPECT_NE(message.find("(1, 1)"), std::string::npos) << message;
  for (const Shape& bad :
       {Shape(Disc{{5, 5}, 0}), Shape(Disc{{5, kNan}, 1}), Shape(Disc{{5, 5}, -1}), Shape(Chain{}),
        Shape(Chain{{{5, 5}}, false}), Shape(Chain{{{5, 5}, {5, 5}}, false}), Shape(Polygon{{{5, 5}, {6, 6}}, {}}),
        Shape(Rectangle{{5, 5}, {1, 0}, 0}), Shape(Rectangle{{5, 5}, {1, 1}, kInf}),
        Shape(Rectangle{{5, 5}, {1, 1}, 1e300}), Shape(Rectangle{{1e7, 5}, {1, 1}, 0}), Shape(Disc{{5, 5}, 1e300})}) {
    EXPECT_TRUE(starts(refusal(Obstacle{"o", bad, {}}), "obstacle 'o': "));
    EXPECT_TRUE(starts(refusal(Door{"d", bad, true, {}}), "door 'd': "));
  }
}

TEST(WorldValidity, NumbersOfThings) {
  EXPECT_EQ(refusal(Obstacle{"o", kBox, {1.5, {}}}), "obstacle 'o': echo: number from 0 to 1 expected, got 1.5");
  EXPECT_TRUE(starts(refusal(Door{"d", kBox, false, {1, 2.0}}), "door 'd': specular_limit: number from 0 to 1.57"));
  EXPECT_TRUE(starts(refusal(Mover{"m", {{5, 5}, 0}, {}, {}, 1, true}), "mover 'm': radius: "));
  EXPECT_EQ(refusal(Mover{"m", kPerson, {}, {}, -1, true}),
            "mover 'm': speed: number from 0 to 1000000 expected, got -1");
  EXPECT_TRUE(starts(refusal(Mover{"m", kPerson, {}, {{kNan, 1}}, 1, true}), "mover 'm': waypoints: coordinates from"));
  EXPECT_TRUE(starts(refusal(Light{"l", {kInf, 5}, 1}), "light 'l': position: coordinates from -1000000 to 1000000"));
  EXPECT_EQ(refusal(Light{"l", {5, 5}, 0}), "light 'l': strength: number above 0 up to 1000000 expected, got 0");
  EXPECT_EQ(refusal(Place{"p", {5, 5}, {}, kNan}),
            "place 'p': tolerance: number above 0 up to 1000000 expected, got nan");
  EXPECT_EQ(refusal(Place{"p", {5, 5}, kInf, 1}),
            "place 'p': heading: number from -1000000 to 1000000 expected, got inf");
}

TEST(WorldValidity, Names) {
  const auto named = [](const std::string& name) { return refusal(Light{name, {5, 5}, 1}); };
  EXPECT_EQ(named("T\xc3\xbcr \"7\" \\ #"), "nothing was refused");
  std::string long_name;
  for (int i = 0; i < 64; ++i) long_name += "\xc3\xbc";
  EXPECT_EQ(named(long_name), "nothing was refused");
  EXPECT_TRUE(starts(named(long_name + "x"), "name: 1 to 64 characters without control characters expected"));
  for (const char* bad :
       {"a\nb", "a\tb", "\x7f", "\xc2\x85", "\xff", "\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80"})
    EXPECT_TRUE(starts(named(bad), "name: ")) << bad;
  EXPECT_TRUE(starts(named(std::string("a\0b", 3)), "name: "));
}

TEST(WorldValidity, NamesAreUnique) {
  World world;
  world.add(Obstacle{"a", kBox, {}});
  const Id b = world.add(Light{"b", {1, 1}, 1});
  EXPECT_EQ(refusal(world, [&] { world.add(Place{"a", {1, 1}, {}, 1}); }), "the name 'a' is taken by an obstacle");
  EXPECT_EQ(refusal(world, [&] { rename(world, b, "a"); }), "the name 'a' is taken by an obstacle");
  rename(world, b, "b");
}

TEST(WorldValidity, HeaderValues) {
  EXPECT_TRUE(
      starts(refusal(Header{"", "", {{0, 0}, {0, 5}}, {}}), "bounds: {low x, low y}, {high x, high y} with low"));
  EXPECT_TRUE(
      starts(refusal(Header{"", "", {{0, 0}, {-1, 5}}, {}}), "bounds: {low x, low y}, {high x, high y} with low"));
  EXPECT_TRUE(starts(refusal(Header{"", "", {{0, 0}, {kNan, 5}}, {}}), "bounds: coordinates from"));
  EXPECT_TRUE(starts(refusal(Header{"", "", {{0, 0}, {1e9, 5}}, {}}), "bounds: coordinates from"));
  EXPECT_TRUE(starts(refusal(Header{"", "", {{0, 0}, {5, 5}}, Pose2{1, kNan, 0}}), "start: coordinates from"));
  EXPECT_TRUE(starts(refusal(Header{"", "", {{0, 0}, {5, 5}}, Pose2{1, 1, kNan}}), "heading: number from"));
  EXPECT_TRUE(starts(refusal(Header{"a\nb", "", {{0, 0}, {5, 5}}, {}}), "title: one line of up to 128 characters"));
  EXPECT_TRUE(starts(refusal(Header{"", "a\rb", {{0, 0}, {5, 5}}, {}}), "note: up to 10000 characters"));
  EXPECT_EQ(refusal(Header{"", "a\n\tb", {{0, 0}, {5, 5}}, {}}), "nothing was refused");
}

TEST(WorldValidity, WhatNeedsFreeGroundLiesWithinTheBounds) {
  EXPECT_EQ(refusal(Place{"p", {10.5, 5}, {}, 1}), "place 'p': (10.5, 5) is outside the bounds (0, 0) to (10, 10)");
  EXPECT_EQ(refusal(Mover{"m", {{-1, 5}, 0.2}, {}, {}, 1, true}),
            "mover 'm': (-1, 5) is outside the bounds (0, 0) to (10, 10)");
  EXPECT_EQ(refusal(Mover{"m", kPerson, {}, {{1, 2}, {11, 2}}, 1, true}),
            "waypoint 2 of mover 'm': (11, 2) is outside the bounds (0, 0) to (10, 10)");
  EXPECT_EQ(refusal(Header{"", "", {{0, 0}, {5, 5}}, Pose2{6, 1, 0}}),
            "the start: (6, 1) is outside the bounds (0, 0) to (5, 5)");
  World world;
  world.add(Place{"p", {8, 5}, {}, 1});
  EXPECT_EQ(refusal(world,
                    [&] {
                      world.set_header({"", "", {{0, 0}, {6, 6}}, {}});
                    }),
            "place 'p': (8, 5) is outside the bounds (0, 0) to (6, 6)");
}

TEST(WorldValidity, ObstaclesStayOffThePlacesWhicheverComesFirst) {
  World world(Header{"", "", {{0, 0}, {10, 10}}, Pose2{1, 1, 0}});
  world.add(Place{"hall", {5, 5}, {}, 0.25});
  world.add(Mover{"anna", {{8, 8}, 0.3}, Motion::waypoints, {{8, 2}}, 1, true});
  world.add(Obstacle{"desk", Rectangle{{3, 3}, {1, 1}, 0}, {}});
  const auto disc = [&](const Vec2& center) {
    return refusal(world, [&] { world.add(Obstacle{"crate", Disc{center, 0.2}, {}}); });
  };
  EXPECT_EQ(disc({1.1, 1}), "obstacle 'crate' covers the start at (1, 1)");
  EXPECT_EQ(disc({5.1, 5}), "obstacle 'crate' covers place 'hall' at (5, 5)");
  EXPECT_EQ(disc({8.4, 8}), "obstacle 'crate' covers mover 'anna' at (8, 8)");
  EXPECT_EQ(disc({8, 2.1}), "obstacle 'crate' covers waypoint 1 of mover 'anna' at (8, 2)");
  EXPECT_EQ(refusal(world,
                    [&] {
                      world.add(Place{"p", {3.2, 3}, {}, 1});
                    }),
            "obstacle 'desk' covers place 'p' at (3.2, 3)");
  EXPECT_EQ(refusal(world,
                    [&] {
                      world.add(Mover{"ben", {{3.7, 3}, 0.3}, {}, {}, 1, true});
                    }),
            "obstacle 'desk' covers mover 'ben' at (3.7, 3)");
  Header header = world.header();
  header.start = Pose2{3, 3, 0};
  EXPECT_EQ(refusal(world, [&] { world.set_header(header); }), "obstacle 'desk' covers the start at (3, 3)");
  EXPECT_EQ(refusal(world,
                    [&] {
                      move(world, {world.find("desk")}, {2, 2});
                    }),
            "obstacle 'desk' covers place 'hall' at (5, 5)");
}

TEST(WorldValidity, ThinWallsCoverOnlyTheirLine) {
  World world(Header{"", "", {{0, 0}, {10, 10}}, Pose2{1, 1, 0}});
  const Chain through{{{0, 1}, {5, 1}}, false}, beside{{{0, 1.01}, {5, 1.01}}, false};
  EXPECT_EQ(refusal(world, [&] { world.add(Obstacle{"w", through, {}}); }), "obstacle 'w' covers the start at (1, 1)");
  world.add(Obstacle{"w", beside, {}});
}

TEST(WorldValidity, DoorsCountOnlyWhileClosed) {
  World world;
  world.add(Place{"door_a", {5, 5}, {}, 0.25});
  const Id door = world.add(Door{"leaf", Chain{{{4, 5}, {6, 5}}, false}, true, {}});
  EXPECT_EQ(refusal(world, [&] { set_open(world, door, false); }),
            "door 'leaf' (closed) covers place 'door_a' at (5, 5)");
  world.remove(world.find("door_a"));
  set_open(world, door, false);
  EXPECT_FALSE(std::get<Door>(world.item(door)).open);
}

TEST(WorldValidity, AllowedThings) {
  World world;
  world.add(Obstacle{"a", kBox, {}});
  world.add(Obstacle{"on top of a", kBox, {}});
  world.add(Obstacle{"half outside", Rectangle{{10, 5}, {4, 1}, 0}, {}});
  world.add(Obstacle{"far outside", Rectangle{{100, 5}, {4, 1}, 0}, {}});
  world.add(Light{"in a", {5, 5}, 1});
  world.add(Mover{"standing", {{1, 1}, 0.2}, Motion::waypoints, {}, 1, true});
  world.add(Place{"under the standing one", {1, 1}, {}, 0.25});
  EXPECT_EQ(world.size(), 7u);
}

TEST(WorldValidity, AThingKeepsItsKind) {
  World world;
  const Id id = world.add(Obstacle{"a", kBox, {}});
  EXPECT_EQ(refusal(world,
                    [&] {
                      world.replace(id, Light{"a", {1, 1}, 1});
                    }),
            "obstacle 'a' cannot be replaced by a light");
}

}  // namespace
}  // namespace meander
