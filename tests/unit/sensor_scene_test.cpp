// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "sensor/scene.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace meander {
namespace {

Shape random_box(Stream& random) {
  return Rectangle{{random.uniform(1, 9), random.uniform(1, 9)},
                   {random.uniform(0.1, 2), random.uniform(0.1, 2)},
                   random.uniform(-3, 3)};
}

Item random_item(Stream& random) {
  switch (random.below(4)) {
    case 0:
      return Door{.name = {}, .shape = random_box(random), .open = random.chance(0.5), .surface = {}};
    case 1:
      return Light{.name = {}, .position = {2, 2}, .strength = 1};
    case 2:
      return Obstacle{
          .name = {}, .shape = Disc{{random.uniform(1, 9), 5}, 0.3}, .surface = {.echo = 0.5, .specular_limit = {}}};
    default:
      return Obstacle{.name = {}, .shape = random_box(random), .surface = {}};
  }
}

/// Everything a fresh look at the world would hold, as numbers.
std::vector<double> contents(const ShapeIndex& index) {
  std::vector<Wall> walls;
  std::vector<Pole> poles;
  index.gather({5, 5}, 100, walls, poles);
  std::vector<double> flat;
  for (const Wall& w : walls)
    flat.insert(flat.end(), {w.a.x(), w.a.y(), w.b.x(), w.b.y(), w.owner * 1.0, index.material(w.material).echo});
  for (const Pole& p : poles)
    flat.insert(flat.end(), {p.disc.center.x(), p.disc.radius, p.owner * 1.0, index.material(p.material).echo});
  return flat;
}

/// One random edit, undo or redo; what is not valid is left out.
void edit(World& world, Stream& random) {
  const std::vector<Id> ids = world.ids();
  const auto any = [&] { return ids[static_cast<std::size_t>(random.below(static_cast<int>(ids.size())))]; };
  switch (random.below(6)) {
    case 0:
      world.undo(1 + random.below(3));
      break;
    case 1:
      world.redo(1 + random.below(3));
      break;
    case 2:
      if (!ids.empty()) world.remove(any());
      break;
    case 3:
      if (!ids.empty()) world.replace(any(), random_item(random));
      break;
    default:
      world.add(random_item(random));
  }
}

TEST(Scene, HoldsWhatAFreshLookAtTheWorldHolds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Stream random(seed, "scene");
    World world;
    Scene followed;
    for (int round = 0; round < 60; ++round) {
      for (int i = random.below(6); i >= 0; --i) {
        try {
          edit(world, random);
        } catch (const Error&) {  // such as a thing replaced by one of another kind
        }
      }
      followed.follow(world);
      Scene fresh;
      fresh.follow(world);
      EXPECT_EQ(contents(followed.walls()), contents(fresh.walls()));
    }
  }
}

TEST(Scene, OpenDoorsAreNotThere) {
  World world;
  const Id id = world.add(Door{.name = "door", .shape = Rectangle{{5, 5}, {1, 1}, 0}, .open = false, .surface = {}});
  Scene scene;
  scene.follow(world);
  EXPECT_TRUE(scene.walls().inside({5, 5}));
  Door open = std::get<Door>(world.item(id));
  open.open = true;
  world.replace(id, open);
  scene.follow(world);
  EXPECT_FALSE(scene.walls().inside({5, 5}));
  world.undo();
  scene.follow(world);
  EXPECT_TRUE(scene.walls().inside({5, 5}));
}

TEST(Scene, NothingChangesWithoutEdits) {
  World world;
  world.add(Obstacle{.name = {}, .shape = Rectangle{{5, 5}, {1, 1}, 0}, .surface = {}});
  Scene scene;
  scene.follow(world);
  const std::uint64_t revision = scene.walls().revision();
  scene.follow(world);
  EXPECT_EQ(scene.walls().revision(), revision);
  world.set_header(Header{.title = "t", .note = {}, .bounds = {{0, 0}, {20, 20}}, .start = {}});
  scene.follow(world);
  EXPECT_EQ(scene.walls().revision(), revision);
}

TEST(Scene, ASceneCanTurnToAYoungerWorld) {
  World old, young;
  for (int i = 0; i < 9; ++i) old.add(Obstacle{.name = {}, .shape = Disc{{i + 0.5, 5}, 0.3}, .surface = {}});
  young.add(Obstacle{.name = {}, .shape = Disc{{2, 2}, 0.3}, .surface = {}});
  Scene scene, fresh;
  scene.follow(old);
  scene.follow(young);
  fresh.follow(young);
  EXPECT_EQ(contents(scene.walls()), contents(fresh.walls()));
}

}  // namespace
}  // namespace meander
