// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/world_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/text_file.hpp"
#include "own_folder.hpp"
#include "world_random.hpp"

namespace meander {
namespace {

const std::string kHead = "[world]\nformat = 1\nbounds = [[0, 0], [10, 10]]\n";

std::string refusal(const std::string& text) {
  try {
    world_from_toml(text, "w.toml");
  } catch (const FileError& error) {
    return error.what();
  }
  return "read";
}

/// The refusal of tables that follow a good header of three lines.
std::string refused(const std::string& text) { return refusal(kHead + text); }

// --- laws ------------------------------------------------------------------------------------------------------------

TEST(WorldFile, ReadingTheTextGivesTheWorldBitByBit) {
  Stream stream(1, "file");
  for (int round = 0; round < 300; ++round) {
    const World world = random_world(stream);
    const std::string text = to_toml(world);
    const World again = world_from_toml(text);
    ASSERT_TRUE(again == world) << text;
    ASSERT_EQ(again.hash(), world.hash());
    ASSERT_EQ(to_toml(again), text);
  }
}

TEST(WorldFile, AwkwardNumbersSurvive) {
  Stream stream(2, "numbers");
  for (int round = 0; round < 2000; ++round) {
    const double exponent = stream.uniform(-300, 5);
    const Vec2 p(std::pow(10, exponent), std::bit_cast<double>(stream.word() >> 12 | 0x3ff0000000000000ull));
    World world;
    world.add(Light{"l", p, 1});
    const Vec2 q = std::get<Light>(world_from_toml(to_toml(world)).item({0, 0})).position;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(q.x()), std::bit_cast<std::uint64_t>(p.x()));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(q.y()), std::bit_cast<std::uint64_t>(p.y()));
  }
}

TEST(WorldFile, EqualWorldsGiveEqualTexts) {
  Stream stream(3, "texts");
  for (int round = 0; round < 50; ++round) {
    World world = random_world(stream);
    const World before = world;
    for (int i = 0; i < 10; ++i) random_edit(stream, world);
    world.undo(static_cast<int>(world.history().size() - before.history().size()));
    ASSERT_TRUE(world == before);
    EXPECT_EQ(to_toml(world), to_toml(before));
  }
}

// --- examples --------------------------------------------------------------------------------------------------------

TEST(WorldFile, TheCanonicalText) {
  World world(Header{"demo", "", {{0, 0}, {4, 3.5}}, Pose2{1, 1, 0}});
  world.add(Obstacle{"crate", Rectangle{{3, 2}, {0.6, 0.4}, 0.5}, {0.25, 0.1}});
  world.add(Door{"leaf", Chain{{{2, 0}, {2, 1}}, false}, true, {}});
  world.add(Place{"hall", {1, 2}, {}, 0.25});
  EXPECT_EQ(to_toml(world),
            "[world]\nformat = 1\ntitle = \"demo\"\nbounds = [[0, 0], [4, 3.5]]\nstart = [1, 1, 0]\n"
            "\n[[obstacle]]\nname = \"crate\"\ncenter = [3, 2]\nsize = [0.6, 0.4]\nheading = 0.5\necho = 0.25\n"
            "specular_limit = 0.1\n"
            "\n[[door]]\nname = \"leaf\"\nfrom = [2, 0]\nto = [2, 1]\nopen = true\n"
            "\n[[place]]\nname = \"hall\"\nposition = [1, 2]\ntolerance = 0.25\n");
}

TEST(WorldFile, WrittenByHand) {
  const World world = world_from_toml(
      "# a comment\nplace = [{position = [1, 1]}, {position = [2.0, 1]}]\n"
      "[world]\nformat = 1\nbounds = [[0, 0], [10, 10]]\nnote = '''\nline\r\nline'''\n"
      "[[obstacle]]\ncenter = [5, 5]\nradius = 1\n"
      "[[obstacle]]\nname = \"obstacle 3\"\npoints = [[0, 0], [1, 0], [1, 0.5]]\nclosed = true\n"
      "[[mover]]\ncenter = [8, 8]\nradius = 0.3\nmotion = \"random_walk\"\n");
  EXPECT_EQ(world.names(), (std::vector<std::string>{"place 1", "place 2", "obstacle 4", "obstacle 3", "mover 5"}));
  EXPECT_EQ(world.header().note, "line\nline");
  EXPECT_EQ(std::get<Mover>(world.item({4, 0})).motion, Motion::random_walk);
}

TEST(WorldFile, KeysAndValues) {
  EXPECT_EQ(refused("[[obstacle]]\nname = 'crate'\ncenter = [3, 2]\nsize = [1, 2, 3]\n"),
            "w.toml:7: [[obstacle]] 'crate': key 'size': [width, height] expected, got 3 numbers");
  EXPECT_EQ(refused("[[obstacle]]\nname = 'crate'\ncenter = [3, 2]\nsize = 3\n"),
            "w.toml:7: [[obstacle]] 'crate': key 'size': [width, height] expected, got number 3");
  EXPECT_EQ(
      refused("[[obstacle]]\ncenter = [3, 2]\nsise = [1, 1]\n"),
      "w.toml:6: [[obstacle]] 'obstacle 1': unknown key 'sise'; did you mean 'size'? (known: name, points, closed, "
      "outer, holes, center, size, heading, radius, echo, specular_limit)");
  EXPECT_EQ(refused("[[obstacle]]\nname = 'a'\ncenter = 'x'\nradius = 1\n"),
            "w.toml:6: [[obstacle]] 'a': key 'center': [x, y] expected, got text 'x'");
  EXPECT_EQ(refused("[[obstacle]]\nname = 'a'\nradius = 1\n"), "w.toml:4: [[obstacle]] 'a': key 'center' is missing");
  EXPECT_EQ(
      refused("[[obstacle]]\nname = 'a'\ncenter = [1, 1]\n"),
      "w.toml:4: [[obstacle]] 'a': the shape is missing: points (wall), outer (polygon), center and size (box) or "
      "center and radius (disc) expected");
  EXPECT_EQ(refused("[[obstacle]]\nname = 'a'\ncenter = [1, 1]\nsize = [1, 1]\nradius = 1\n"),
            "w.toml:8: [[obstacle]] 'a': key 'radius' does not go with 'size': a box has center, size, heading");
  EXPECT_EQ(refused("[[obstacle]]\nname = 'a'\npoints = [[1, 1], [2]]\n"),
            "w.toml:6: [[obstacle]] 'a': key 'points': points [x, y] expected, got 1 number");
  EXPECT_EQ(refused("[[obstacle]]\nname = 7\n"),
            "w.toml:5: [[obstacle]]: key 'name': text in quotes expected, got number 7");
  EXPECT_EQ(refused("[[obstacle]]\nname = ''\n"),
            "w.toml:5: [[obstacle]] '': key 'name': 1 to 64 characters expected, got none");
  EXPECT_EQ(refused("[[door]]\nname = 'a'\nopen = 'yes'\nfrom = [1, 1]\nto = [2, 2]\n"),
            "w.toml:6: [[door]] 'a': key 'open': true or false expected, got text 'yes'");
  EXPECT_EQ(
      refused("[[mover]]\nname = 'a'\ncenter = [1, 1]\nradius = 1\nmotion = 'randomwalk'\n"),
      "w.toml:8: [[mover]] 'a': key 'motion': unknown value 'randomwalk', one of waypoints, random_walk; did you mean "
      "'random_walk'?");
}

TEST(WorldFile, WhatTheWorldRefuses) {
  EXPECT_EQ(refused("[[place]]\nname = 'a'\nposition = [11, 1]\n"),
            "w.toml:4: place 'a': (11, 1) is outside the bounds (0, 0) to (10, 10)");
  EXPECT_EQ(refused("[[place]]\nname = 'a'\nposition = [1, 1]\n[[place]]\nname = 'a'\nposition = [2, 2]\n"),
            "w.toml:7: [[place]] 'a': the name 'a' is taken by a place");
  EXPECT_EQ(
      refused("[[place]]\nname = 'a'\nposition = [1, 1]\n[[obstacle]]\nname = 'b'\ncenter = [1, 1]\nradius = 1\n"),
      "w.toml:7: obstacle 'b' covers place 'a' at (1, 1)");
  EXPECT_EQ(refused("[[obstacle]]\nname = 'b'\ncenter = [1, 1]\nradius = nan\n"),
            "w.toml:4: obstacle 'b': radius: a number from 1e-06 to 1e+06 m expected, got nan");
  EXPECT_EQ(refused("[[light]]\nname = 'b'\nposition = [1, -inf]\n").substr(0, 45),
            "w.toml:4: light 'b': position: coordinates fr");
}

TEST(WorldFile, TheFrame) {
  EXPECT_EQ(refusal(""), "w.toml: the table [world] with format = 1 is missing");
  EXPECT_EQ(refusal("[wrld]\n"),
            "w.toml:1: unknown key 'wrld'; did you mean 'world'? (known: world, obstacle, door, mover, light, place)");
  EXPECT_EQ(refusal("[world]\nformat = 2\n"), "w.toml:2: [world]: key 'format': 1 expected, got 2");
  EXPECT_EQ(refusal("[world]\nformat = 1\n"), "w.toml:1: [world]: key 'bounds' is missing");
  EXPECT_EQ(refusal("[world]\nbounds = [[0, 0], [1, 1]]\n"), "w.toml:1: [world]: key 'format' is missing");
  EXPECT_EQ(refusal("[world]\nformat = 1\nbounds = [[0, 0]]\n"),
            "w.toml:3: [world]: key 'bounds': [[low x, low y], [high x, high y]] expected");
  EXPECT_EQ(refusal("[world]\nformat = 1\nbounds = [[0, 0], [0, 1]]\n").substr(0, 26), "w.toml:1: [world]: bounds:");
  EXPECT_EQ(refusal(kHead + "start = [1, 1]\n"),
            "w.toml:4: [world]: key 'start': [x, y, heading] expected, got 2 numbers");
  EXPECT_EQ(refused("[obstacle]\n"), "w.toml:4: [[obstacle]] with double brackets expected, got a table");
  EXPECT_EQ(refusal("[world\n").substr(0, 11), "w.toml:1:7:");
  EXPECT_EQ(refusal(std::string(10000, '[')).substr(0, 7), "w.toml:");
  EXPECT_EQ(refusal("\xff").substr(0, 7), "w.toml:");
}

// --- files -----------------------------------------------------------------------------------------------------------

TEST(WorldFile, WritesAndReads) {
  const std::string path = (own_folder() / "world.toml").string();
  Stream stream(4, "disk");
  const World world = random_world(stream);
  write_world(path, world);
  EXPECT_TRUE(read_world(path) == world);
  EXPECT_EQ(read_text_file(path, 1 << 20), to_toml(world));
  std::filesystem::remove(path);
  EXPECT_THROW(read_world(path), FileError);
}

TEST(WorldFile, LargeWorldsComeBack) {
  World world(Header{"big", "", {{0, 0}, {200, 200}}, {}});
  world.transaction([&] {
    for (int i = 0; i < 20000; ++i)
      world.add(Obstacle{"", Rectangle{{i % 141 * 1.4, i / 141 * 1.35}, {0.2, 0.2}, 0}, {}});
  });
  EXPECT_TRUE(world_from_toml(to_toml(world)) == world);
}

}  // namespace
}  // namespace meander
