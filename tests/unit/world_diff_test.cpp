// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/world_diff.hpp"

#include <gtest/gtest.h>

#include "world_random.hpp"

namespace meander {
namespace {

TEST(WorldDiff, IsEmptyForEqualWorldsAndOnlyForThem) {
  Stream stream(1, "diff");
  int different = 0;
  for (int round = 0; round < 200; ++round) {
    const World a = random_world(stream, 20);
    World b = a;
    EXPECT_TRUE(difference(a, b).empty());
    random_edit(stream, b);
    EXPECT_EQ(difference(a, b).empty(), a == b);
    EXPECT_EQ(difference(b, a).empty(), a == b);
    different += a == b ? 0 : 1;
  }
  EXPECT_GT(different, 100);
}

TEST(WorldDiff, SpeaksInWords) {
  World a(Header{"a", "", {{0, 0}, {10, 10}}, Pose2{1, 1, 0}});
  a.add(Obstacle{"desk", Rectangle{{3, 3}, {1, 1}, 0}, {}});
  a.add(Obstacle{"crate", Rectangle{{5, 3}, {1, 1}, 0}, {}});
  a.add(Door{"door", Chain{{{8, 0}, {9, 0}}, false}, false, {}});
  World b = a;
  b.set_header({"b", "x\ny", {{0, 0}, {10, 10}}, {}});
  b.replace(b.find("desk"), Obstacle{"desk", Rectangle{{4, 3}, {1, 1}, 0.5}, {0.5, 0.1}});
  b.remove(b.find("crate"));
  set_open(b, b.find("door"), true);
  b.add(Place{"hall", {6, 6}, {}, 0.25});
  EXPECT_EQ(difference(a, b),
            (std::vector<std::string>{
                "world: title 'a' -> 'b', note '' -> a text of several lines, start (1, 1, 0) -> none",
                "obstacle 'desk': center (3, 3) -> (4, 3), heading 0 -> 0.5, echo 1 -> 0.5, specular_limit none -> 0.1",
                "removed obstacle 'crate'",
                "door 'door': open false -> true",
                "added place 'hall'",
            }));
}

TEST(WorldDiff, TellsAnotherOrder) {
  World a, b;
  a.add(Light{"x", {1, 1}, 1});
  a.add(Light{"y", {1, 1}, 1});
  b.add(Light{"y", {1, 1}, 1});
  b.add(Light{"x", {1, 1}, 1});
  EXPECT_EQ(difference(a, b), std::vector<std::string>{"order: 'y' where 'x' was"});
}

TEST(WorldScript, TellsWhatStandsInStepsAndForgetsWhatWasUndone) {
  World world(Header{"demo", "two\nlines", {{0, 0}, {10, 10}}, Pose2{1, 1, 0}});
  world.add(Obstacle{"desk", Rectangle{{3, 3}, {1, 1}, 0}, {}});
  world.forget_history();
  world.add(Obstacle{"crate", Disc{{5, 3}, 0.5}, {}});
  world.add(Light{"mistake", {5, 3}, 1});
  world.undo();
  world.transaction([&] {
    world.add(Door{"door", Chain{{{8, 0}, {9, 0}}, false}, false, {}});
    rename(world, world.find("door"), "gate \"1\"");
    world.remove(world.find("gate \"1\""));
  });
  Header header = world.header();
  header.start.reset();
  world.set_header(header);
  EXPECT_EQ(
      world_script(world),
      "local world = meander.world.new { title = \"demo\", note = \"two\\nlines\", bounds = {{0, 0}, {10, 10}}, "
      "start = {1, 1, 0} }\n"
      "world:add_box { center = {3, 3}, size = {1, 1}, name = \"desk\" }\n"
      "world:add_disc { center = {5, 3}, radius = 0.5, name = \"crate\" }\n"
      "world:transaction(function()\n"
      "  world:add_door { from = {8, 0}, to = {9, 0}, open = false, name = \"door\" }\n"
      "  world:replace(\"door\", { from = {8, 0}, to = {9, 0}, open = false, echo = 1, name = \"gate \\\"1\\\"\" })\n"
      "  world:remove(\"gate \\\"1\\\"\")\n"
      "end)\n"
      "world:set { title = \"demo\", note = \"two\\nlines\", bounds = {{0, 0}, {10, 10}}, start = false }\n"
      "return world\n");
}

}  // namespace
}  // namespace meander
