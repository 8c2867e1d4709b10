// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/generate_clutter.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "world/world_file.hpp"

namespace meander {
namespace {

std::vector<Shape> shapes_of(const World& world) {
  std::vector<Shape> shapes;
  for (const Id id : world.ids())
    if (const Shape* shape = blocking_shape(world.item(id))) shapes.push_back(*shape);
  return shapes;
}

double clearance(const std::vector<Shape>& shapes, const Vec2& point) {
  double least = 1e9;
  for (const Shape& shape : shapes) least = std::min(least, distance(shape, point));
  return least;
}

/// Is there a way from a to b over points 2 cm apart that all keep `room`?
bool reachable(const std::vector<Shape>& shapes, const Box& bounds, const Vec2& a, const Vec2& b, double room) {
  constexpr double kStep = 0.02;
  const int columns = static_cast<int>(bounds.size().x() / kStep), rows = static_cast<int>(bounds.size().y() / kStep);
  const auto cell = [&](const Vec2& p) {
    return std::pair{static_cast<int>(p.x() / kStep), static_cast<int>(p.y() / kStep)};
  };
  std::vector<char> seen(static_cast<std::size_t>(columns * rows), 0);
  std::vector<std::pair<int, int>> open{cell(a)};
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    if (x < 0 || y < 0 || x >= columns || y >= rows) continue;
    char& mark = seen[static_cast<std::size_t>(y * columns + x)];
    if (mark) continue;
    mark = 1;
    if (clearance(shapes, {(x + 0.5) * kStep, (y + 0.5) * kStep}) < room) continue;
    if (std::pair{x, y} == cell(b)) return true;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) open.emplace_back(x + dx, y + dy);
  }
  return false;
}

TEST(GenerateClutter, TheSameSeedGivesTheSameWorldAndAnotherAnother) {
  const auto one = generate_clutter({.seed = 5}), again = generate_clutter({.seed = 5}),
             other = generate_clutter({.seed = 6});
  ASSERT_TRUE(one && again && other);
  EXPECT_TRUE(*one == *again);
  EXPECT_NE(one->hash(), other->hash());
  EXPECT_TRUE(world_from_toml(to_toml(*one)) == *one);
}

TEST(GenerateClutter, TheRouteThatIsPromisedIsThere) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto world = generate_clutter({.seed = seed, .density = 0.12, .route = 0.45, .width = 6, .height = 5});
    if (!world) continue;
    const auto shapes = shapes_of(*world);
    const Vec2 start = world->header().start->position();
    const Vec2 goal = std::get<Place>(world->item(world->find("goal"))).position;
    EXPECT_GE(clearance(shapes, start), 0.45) << seed;
    EXPECT_GE(clearance(shapes, goal), 0.45) << seed;
    EXPECT_TRUE(reachable(shapes, world->header().bounds, start, goal, 0.45)) << seed;
  }
}

TEST(GenerateClutter, CoversTheShareAskedFor) {
  for (const double density : {0.05, 0.1, 0.15}) {
    const auto world = generate_clutter({.seed = 2, .density = density, .route = 0.3});
    ASSERT_TRUE(world);
    auto shapes = shapes_of(*world);
    shapes.erase(shapes.begin(), shapes.begin() + 4);  // the walls
    int covered = 0;
    for (int x = 0; x < 500; ++x)
      for (int y = 0; y < 500; ++y)
        covered += std::any_of(shapes.begin(), shapes.end(), [&](const Shape& shape) {
          return contains(shape, {(x + 0.5) / 50, (y + 0.5) / 50});
        });
    EXPECT_NEAR(covered / 250000.0, density, 0.01) << "one object more or less";
  }
}

TEST(GenerateClutter, AnEmptyRoomIsClutterToo) {
  const auto world = generate_clutter({.density = 0});
  ASSERT_TRUE(world);
  EXPECT_EQ(world->size(), 5u);
}

TEST(GenerateClutter, TellsWhenThereIsNone) {
  EXPECT_FALSE(generate_clutter({.density = 0.3, .route = 0.8, .draws = 3}));
  EXPECT_FALSE(generate_clutter({.route = 9}));
  EXPECT_FALSE(generate_clutter({.box_side_min = 9, .box_side_max = 9.9, .boxes = 1, .draws = 1}));
}

TEST(GenerateClutter, OptionsAreChecked) {
  EXPECT_THROW(generate_clutter({.density = 0.9}), ArgumentError);
  EXPECT_THROW(generate_clutter({.disc_radius_min = 0.4, .disc_radius_max = 0.3}), ArgumentError);
  EXPECT_THROW(generate_clutter({.draws = 0}), ArgumentError);
}

}  // namespace
}  // namespace meander
