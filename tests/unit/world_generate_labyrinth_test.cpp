// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/generate_labyrinth.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "world/world_file.hpp"

namespace meander {
namespace {

bool crossed(const World& world, const Vec2& a, const Vec2& b) {
  for (const Id id : world.ids()) {
    const Shape* shape = blocking_shape(world.item(id));
    if (!shape) continue;
    for (int i = 0; i <= 100; ++i)
      if (distance(*shape, a + (i / 100.0) * (b - a)) < 0.0125) return true;
  }
  return false;
}

TEST(LabyrinthWorld, ThereIsAWallExactlyWhereTheLabyrinthHasOne) {
  for (const double jitter : {0.0, 0.12}) {
    const Labyrinth cells = make_labyrinth({.seed = 3, .columns = 7, .rows = 5, .loops = 0.1, .rooms = 1});
    const World world = labyrinth_world(cells, {.corridor = 1.2, .jitter = jitter}, 3);
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 7; ++x)
        for (int side = 0; side < kSides; ++side) {
          const Cell next = beside({x, y}, side);
          const Vec2 from = 1.2 * Vec2(x + 0.5, y + 0.5), to = 1.2 * Vec2(next.x + 0.5, next.y + 0.5);
          EXPECT_EQ(crossed(world, from, to), !cells.open({x, y}, side)) << x << " " << y << " side " << side;
        }
  }
}

TEST(LabyrinthWorld, IsTheSameForTheSameSeedAndSurvivesItsFile) {
  const Labyrinth cells = make_labyrinth({.seed = 8, .columns = 9, .rows = 9});
  const World one = labyrinth_world(cells, {.jitter = 0.2}, 8), again = labyrinth_world(cells, {.jitter = 0.2}, 8);
  EXPECT_TRUE(one == again);
  EXPECT_FALSE(one == labyrinth_world(cells, {.jitter = 0.2}, 9));
  EXPECT_TRUE(world_from_toml(to_toml(one)) == one);
  EXPECT_EQ(std::get<Place>(one.item(one.find("goal"))).position, Vec2(8.5, 8.5));
  EXPECT_THROW(labyrinth_world(cells, {.corridor = 0.1}, 1), ArgumentError);
}

}  // namespace
}  // namespace meander
