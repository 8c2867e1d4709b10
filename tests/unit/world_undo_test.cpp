// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <limits>

#include "base/work.hpp"
#include "world/world_file.hpp"
#include "world_random.hpp"

namespace meander {
namespace {

constexpr int kAll = std::numeric_limits<int>::max();

/// Law: undo after do is identity, and redo after undo, at every point of a random history.
TEST(WorldUndo, UndoAndRedoWalkThroughTheSameStates) {
  Stream stream(1, "undo");
  for (int round = 0; round < 60; ++round) {
    World world(random_header(stream));
    std::vector<World> states{world};
    while (states.size() < 40) {
      random_edit(stream, world);
      if (world.history().size() == states.size()) states.push_back(world);
    }
    for (std::size_t i = states.size(); i-- > 0;) {
      ASSERT_TRUE(world == states[i]);
      ASSERT_EQ(world.ids(), states[i].ids());
      ASSERT_EQ(world.undo(), i > 0 ? 1 : 0);
    }
    for (std::size_t i = 1; i < states.size(); ++i) {
      ASSERT_EQ(world.redo(), 1);
      ASSERT_TRUE(world == states[i]);
      ASSERT_EQ(world.ids(), states[i].ids());
    }
    EXPECT_EQ(world.redo(), 0);
  }
}

TEST(WorldUndo, HoldsOnARandomWalkThroughHistory) {
  Stream stream(2, "walk");
  for (int round = 0; round < 40; ++round) {
    World world(random_header(stream));
    std::vector<std::uint64_t> hashes{world.hash()};
    for (int i = 0; i < 150; ++i) {
      const std::size_t before = world.history().size();
      if (stream.chance(0.4))
        world.undo(1 + stream.below(4));
      else if (stream.chance(0.3))
        world.redo(1 + stream.below(4));
      else if (random_edit(stream, world); world.history().size() == before + 1)
        hashes.resize(before + 1), hashes.push_back(world.hash());
      ASSERT_EQ(world.hash(), hashes.at(world.history().size()));
    }
  }
}

TEST(WorldUndo, StepsBeyondTheHistoryAreCounted) {
  World world;
  world.add(Light{"a", {1, 1}, 1});
  world.add(Light{"b", {1, 1}, 1});
  EXPECT_EQ(world.undo(0), 0);
  EXPECT_EQ(world.undo(-3), 0);
  EXPECT_EQ(world.undo(kAll), 2);
  EXPECT_EQ(world.redo(kAll), 2);
  EXPECT_EQ(world.size(), 2u);
}

TEST(WorldUndo, ANewEditForgetsWhatWasUndone) {
  World world;
  world.add(Light{"a", {1, 1}, 1});
  world.undo();
  world.add(Light{"b", {1, 1}, 1});
  EXPECT_EQ(world.redo(), 0);
}

TEST(WorldUndo, ARefusedEditKeepsWhatWasUndone) {
  World world;
  world.add(Light{"a", {1, 1}, 1});
  world.undo();
  EXPECT_FALSE(tried([&] { world.add(Light{"b", {1, 1}, -1}); }));
  EXPECT_FALSE(tried([&] {
    world.transaction([&] {
      world.add(Light{"b", {1, 1}, 1});
      world.add(Light{"c", {1, 1}, -1});
    });
  }));
  EXPECT_EQ(world.redo(), 1);
  EXPECT_EQ(world.names(), std::vector<std::string>{"a"});
}

TEST(WorldUndo, TheLogSaysEverythingThatHappened) {
  World world;
  const Id id = world.add(Light{"a", {1, 1}, 1});
  world.undo();
  world.redo();
  ASSERT_EQ(world.revision(), 3u);
  EXPECT_EQ(world.log()[0], Edit(Add{id, Light{"a", {1, 1}, 1}}));
  EXPECT_EQ(world.log()[1], Edit(Remove{id}));
  EXPECT_EQ(world.log()[2], world.log()[0]);
}

TEST(WorldUndo, AWorldBeginsWithoutHistory) {
  World world(Header{"x", "", {{0, 0}, {5, 5}}, {}});
  EXPECT_EQ(world.undo(), 0);
  EXPECT_EQ(world.header().title, "x");
  EXPECT_EQ(world_from_toml(to_toml(world)).undo(), 0);
}

// --- transactions ----------------------------------------------------------------------------------------------------

TEST(WorldTransaction, IsAllOrNothing) {
  Stream stream(3, "transaction");
  for (int round = 0; round < 100; ++round) {
    World world = random_world(stream, 20);
    world.undo(stream.below(5));
    const World before = world;
    const auto edits = [&] {
      for (int i = 0; i < 10; ++i) random_edit(stream, world);
    };
    EXPECT_THROW(world.transaction([&] {
      edits();
      world.transaction(edits);
      throw Cancelled{};
    }),
                 Cancelled);
    ASSERT_TRUE(world == before);
    ASSERT_EQ(world.ids(), before.ids());
    ASSERT_EQ(world.history().size(), before.history().size());
    World undone = before;
    EXPECT_EQ(world.redo(kAll), undone.redo(kAll));
    EXPECT_TRUE(world == undone);
  }
}

TEST(WorldTransaction, IsOneUndoStep) {
  Stream stream(4, "step");
  for (int round = 0; round < 50; ++round) {
    World world = random_world(stream, 20);
    const World before = world;
    if (!tried([&] {
          world.transaction([&] {
            for (int i = 0; i < 10; ++i) random_edit(stream, world);
            world.add(Light{"the last", {0, 0}, 1});
          });
        }))
      continue;
    const World after = world;
    EXPECT_EQ(world.undo(), 1);
    EXPECT_TRUE(world == before);
    EXPECT_EQ(world.redo(), 1);
    EXPECT_TRUE(world == after);
  }
}

TEST(WorldTransaction, AnInnerOneFailsAlone) {
  World world;
  world.transaction([&] {
    world.add(Light{"outer", {1, 1}, 1});
    EXPECT_FALSE(tried([&] {
      world.transaction([&] {
        world.add(Light{"inner", {1, 1}, 1});
        fail("no");
      });
    }));
    world.add(Light{"outer 2", {1, 1}, 1});
  });
  EXPECT_EQ(world.names(), (std::vector<std::string>{"outer", "outer 2"}));
  EXPECT_EQ(world.undo(), 1);
  EXPECT_EQ(world.size(), 0u);
}

TEST(WorldTransaction, WithoutEditsIsNoStep) {
  World world;
  world.add(Light{"a", {1, 1}, 1});
  world.undo();
  world.transaction([] {});
  EXPECT_EQ(world.redo(), 1);
}

TEST(WorldTransaction, ThingsMayPassThroughEachOther) {
  World world;
  world.add(Obstacle{"desk", Disc{{2, 2}, 0.5}, {}});
  world.add(Place{"seat", {3, 2}, {}, 0.25});
  const auto all = world.ids();
  move(world, all, {1, 0});  // the desk goes where the seat still is
  EXPECT_EQ(std::get<Place>(world.item(all[1])).position, Vec2(4, 2));
  const World before = world;
  EXPECT_FALSE(tried([&] { move(world, {all[0]}, {1, 0}); }));
  EXPECT_TRUE(world == before);
}

TEST(WorldTransaction, NoCopyUndoOrRedoInside) {
  World world;
  world.transaction([&] {
    world.add(Light{"a", {1, 1}, 1});
    EXPECT_FALSE(tried([&] { World copy = world; }));
    EXPECT_FALSE(tried([&] { world = World(); }));
    EXPECT_FALSE(tried([&] { world.undo(); }));
    EXPECT_FALSE(tried([&] { world.redo(); }));
    EXPECT_FALSE(tried([&] { world.forget_history(); }));
  });
  EXPECT_EQ(world.size(), 1u);
}

}  // namespace
}  // namespace meander
