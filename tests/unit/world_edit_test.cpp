// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "world_random.hpp"

namespace meander {
namespace {

Obstacle box(const std::string& name, const Vec2& center, const Vec2& size = {1, 1}) {
  return {name, Rectangle{center, size, 0}, {}};
}

template <class E>
std::string message(const std::function<void()>& body) {
  try {
    body();
  } catch (const E& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(WorldEdit, ReplayingTheLogGivesAnEqualWorld) {
  Stream stream(1, "log");
  for (int round = 0; round < 100; ++round) {
    World world = random_world(stream);
    world.undo(stream.below(20));
    world.redo(stream.below(10));
    for (int i = 0; i < 5; ++i) random_edit(stream, world);
    World replayed;
    replayed.transaction([&] {
      for (const Edit& edit : world.log()) replayed.apply(edit);
    });
    EXPECT_TRUE(replayed == world);
    EXPECT_EQ(replayed.hash(), world.hash());
    EXPECT_EQ(replayed.ids(), world.ids());
  }
}

TEST(WorldEdit, RefusedEditsChangeNothing) {
  Stream stream(2, "refused");
  int refused = 0;
  World world(random_header(stream));
  for (int i = 0; i < 3000; ++i) {
    const World before = world;
    const Item item = random_item(stream);
    if (tried([&] { world.add(item); })) continue;
    ++refused;
    ASSERT_TRUE(world == before);
    ASSERT_EQ(world.revision(), before.revision());
    ASSERT_EQ(world.history().size(), before.history().size());
    if (world.size() > 30) world = World(random_header(stream));
  }
  EXPECT_GT(refused, 100);
}

TEST(WorldEdit, EqualWorldsHashEquallyAndChangedOnesDoNot) {
  Stream stream(3, "hash");
  for (int round = 0; round < 100; ++round) {
    const World world = random_world(stream);
    World fork = world;
    EXPECT_EQ(fork.hash(), world.hash());
    fork.add(Light{"", random_point(stream), 2});
    EXPECT_FALSE(fork == world);
    EXPECT_NE(fork.hash(), world.hash());
  }
}

TEST(WorldEdit, ForksAreIndependent) {
  World world;
  const Id id = world.add(box("crate", {3, 3}));
  World fork = world;
  fork.remove(id);
  world.replace(id, box("chest", {4, 4}));
  EXPECT_EQ(name_of(world.item(id)), "chest");
  EXPECT_FALSE(fork.alive(id));
  EXPECT_EQ(fork.undo(), 1);
  EXPECT_EQ(name_of(fork.item(id)), "crate");
}

TEST(WorldEdit, NamesAreFilledInAndFound) {
  World world;
  world.add(box("", {3, 3}));
  world.add(Place{"hall", {1, 1}, {}, 0.25});
  const Id third = world.add(box("", {5, 5}));
  EXPECT_EQ(world.names(), (std::vector<std::string>{"obstacle 1", "hall", "obstacle 3"}));
  EXPECT_EQ(world.find("obstacle 3"), third);
  world.replace(third, box("", {6, 6}));
  EXPECT_EQ(world.find("obstacle 3"), third);
  EXPECT_EQ(message<ArgumentError>([&] { static_cast<void>(world.find("hal")); }),
            "no 'hal' in this world; did you mean 'hall'?");
}

TEST(WorldEdit, FilledInNamesAvoidTakenOnes) {
  World world;
  world.add(box("obstacle 2", {3, 3}));
  world.add(box("", {5, 5}));
  EXPECT_EQ(world.names().back(), "obstacle 3");
}

TEST(WorldEdit, StaleHandleNamesWhatWasRemoved) {
  World world;
  const Id id = world.add(box("crate", {3, 3}));
  rename(world, id, "chest");
  world.remove(id);
  EXPECT_EQ(message<StaleError>([&] { static_cast<void>(world.item(id)); }), "obstacle 'chest' was removed");
  EXPECT_EQ(message<StaleError>([&] { world.remove(id); }), "obstacle 'chest' was removed");
  EXPECT_EQ(message<StaleError>([&] { world.replace(id, box("x", {1, 1})); }), "obstacle 'chest' was removed");
  EXPECT_EQ(message<StaleError>([&] {
              static_cast<void>(world.item({9, 4}));
            }),
            "no thing of this world has the id 9.4");
}

TEST(WorldEdit, IdsNeverComeBackExceptByUndo) {
  World world;
  const Id first = world.add(box("a", {3, 3}));
  world.undo();
  const Id second = world.add(box("b", {3, 3}));
  EXPECT_NE(first, second);
  EXPECT_FALSE(world.alive(first));
  world.remove(second);
  const Id third = world.add(box("c", {3, 3}));
  EXPECT_NE(third, second);
  EXPECT_EQ(world.undo(2), 2);
  EXPECT_TRUE(world.alive(second));
  EXPECT_EQ(name_of(world.item(second)), "b");
}

TEST(WorldEdit, ReplayedIdsMustBeFree) {
  World world;
  const Id id = world.add(box("a", {3, 3}));
  EXPECT_EQ(message<ArgumentError>([&] {
              world.apply(Add{id, box("b", {5, 5})});
            }),
            "obstacle 'b': the id 0.0 is not free");
  EXPECT_EQ(message<ArgumentError>([&] {
              world.apply(Add{{4000000000u, 0}, box("b", {5, 5})});
            }),
            "obstacle 'b': the id 4000000000.0 is not free");
}

TEST(WorldEdit, ManyObstacles) {
  World world(Header{"big", "", {{0, 0}, {200, 200}}, Pose2{199, 199, 0}});
  world.add(Place{"hall", {199, 198}, {}, 0.25});
  for (int i = 0; i < 20000; ++i) world.add(box("", {i % 141 * 1.4, i / 141 * 1.35}, {0.2, 0.2}));
  EXPECT_EQ(world.size(), 20001u);
  EXPECT_EQ(world.undo(20000), 20000);
  EXPECT_EQ(world.names(), std::vector<std::string>{"hall"});
}

TEST(WorldEdit, NumbersAreStoredInOneForm) {
  World a, b;
  a.add(Obstacle{"o", Polygon{{{0, 0}, {0, 1}, {1, 1}}, {}}, {}});
  b.add(Obstacle{"o", Polygon{{{-0.0, 0}, {1, 1}, {0, 1}}, {}}, {}});
  a.add(Place{"p", {3, 3}, kPi / 2, 1});
  b.add(Place{"p", {3, 3}, kPi / 2 - 4 * kPi, 1});
  EXPECT_EQ(std::get<Place>(b.item(b.find("p"))).heading.value(), std::get<Place>(b.item(b.find("p"))).heading.value());
  EXPECT_NEAR(*std::get<Place>(b.item(b.find("p"))).heading, kPi / 2, 1e-12);
  EXPECT_EQ(a.item(a.find("o")), b.item(b.find("o")));
}

}  // namespace
}  // namespace meander
