// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/editing.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "world/text.hpp"

namespace meander {
namespace {

World room() {
  World world(Header{"room", "", {{0, 0}, {10, 10}}, {}});
  world.add(Obstacle{"desk 1", Rectangle{{2, 2}, {1, 0.5}, 0}, {}});
  world.add(Obstacle{"desk 2", Rectangle{{4, 2}, {1, 0.5}, 0}, {}});
  world.add(Door{"door", Chain{{{8, 0}, {9, 0}}, false}, false, {}});
  world.add(Mover{"anna", {{6, 6}, 0.25}, Motion::waypoints, {{7, 6}}, 0.5, true});
  world.add(Place{"seat", {3, 4}, 0.5, 0.25});
  world.add(Light{"lamp", {5, 5}, 1});
  return world;
}

template <class T>
const T& get(const World& world, const std::string& name) {
  return std::get<T>(world.item(world.find(name)));
}

std::vector<std::string> names(const World& world, const std::string& pattern) {
  std::vector<std::string> result;
  for (const Id id : matching(world, pattern)) result.push_back(name_of(world.item(id)));
  return result;
}

TEST(WorldEditing, NamesMatchPatterns) {
  const World world = room();
  EXPECT_EQ(names(world, "desk *"), (std::vector<std::string>{"desk 1", "desk 2"}));
  EXPECT_EQ(names(world, "d*"), (std::vector<std::string>{"desk 1", "desk 2", "door"}));
  EXPECT_EQ(names(world, "????"), (std::vector<std::string>{"door", "anna", "seat", "lamp"}));
  EXPECT_EQ(names(world, "lamp"), std::vector<std::string>{"lamp"});
  EXPECT_EQ(names(world, "*").size(), world.size());
  EXPECT_TRUE(names(world, "lam").empty());
  EXPECT_TRUE(names(world, "").empty());
}

TEST(WorldEditing, PatternsTakeWholeCharactersAndBacktrack) {
  EXPECT_TRUE(fits_pattern("T\xc3\xbcr", "T?r"));
  EXPECT_FALSE(fits_pattern("T\xc3\xbcr", "T??r"));
  EXPECT_TRUE(fits_pattern("ababac", "*ab*c"));
  EXPECT_TRUE(fits_pattern("aaab", "*a*ab"));
  EXPECT_FALSE(fits_pattern("aaab", "*b?"));
  EXPECT_TRUE(fits_pattern("", "**"));
  EXPECT_FALSE(fits_pattern(std::string(5000, 'a'), "*a*a*a*a*a*a*a*a*b"));
}

TEST(WorldEditing, MovesEverythingThatBelongsToAThing) {
  World world = room();
  move(world, world.ids(), {1, 1});
  EXPECT_EQ(std::get<Rectangle>(get<Obstacle>(world, "desk 2").shape).center, Vec2(5, 3));
  EXPECT_EQ(std::get<Chain>(get<Door>(world, "door").shape).points[1], Vec2(10, 1));
  EXPECT_EQ(get<Mover>(world, "anna").disc.center, Vec2(7, 7));
  EXPECT_EQ(get<Mover>(world, "anna").waypoints[0], Vec2(8, 7));
  EXPECT_EQ(get<Place>(world, "seat").position, Vec2(4, 5));
  EXPECT_EQ(get<Light>(world, "lamp").position, Vec2(6, 6));
  EXPECT_EQ(world.undo(), 1);
  EXPECT_TRUE(world == room());
}

TEST(WorldEditing, AFullTurnAndAScaleThereAndBackChangeNothingVisible) {
  World world = room();
  const auto ids = matching(world, "*s*");
  for (int i = 0; i < 4; ++i) turn(world, ids, kPi / 2);
  scale(world, ids, 1.5);
  scale(world, ids, 1 / 1.5);
  EXPECT_LT((std::get<Rectangle>(get<Obstacle>(world, "desk 1").shape).center - Vec2(2, 2)).norm(), 1e-12);
  EXPECT_LT((get<Place>(world, "seat").position - Vec2(3, 4)).norm(), 1e-12);
  EXPECT_NEAR(*get<Place>(world, "seat").heading, 0.5, 1e-12);
  EXPECT_EQ(world.undo(6), 6);
  EXPECT_TRUE(world == room());
}

TEST(WorldEditing, TurnsAboutTheMiddleOfTheGroupOrAPoint) {
  World world = room();
  turn(world, matching(world, "desk*"), kPi / 2);
  EXPECT_LT((std::get<Rectangle>(get<Obstacle>(world, "desk 1").shape).center - Vec2(3, 1)).norm(), 1e-12);
  turn(world, {world.find("anna")}, kPi, Vec2(5, 6));
  EXPECT_LT((get<Mover>(world, "anna").waypoints[0] - Vec2(3, 6)).norm(), 1e-12);
  EXPECT_EQ(center_of(world, {}), Vec2(0, 0));
}

TEST(WorldEditing, ScalesSizesToo) {
  World world = room();
  scale(world, {world.find("desk 1")}, 2);
  const auto& desk = std::get<Rectangle>(get<Obstacle>(world, "desk 1").shape);
  EXPECT_EQ(desk.center, Vec2(2, 2));
  EXPECT_EQ(desk.size, Vec2(2, 1));
}

TEST(WorldEditing, SnapsToAGrid) {
  World world = room();
  move(world, world.ids(), {0.03, -0.04});
  world.add(Obstacle{"fence", Chain{{{1.1, 8.9}, {3.2, 9.1}}, false}, {}});
  snap(world, world.ids(), 0.5);
  EXPECT_EQ(std::get<Rectangle>(get<Obstacle>(world, "desk 2").shape).center, Vec2(4, 2));
  EXPECT_EQ(std::get<Chain>(get<Obstacle>(world, "fence").shape).points, (std::vector<Vec2>{{1, 9}, {3, 9}}));
  EXPECT_EQ(get<Place>(world, "seat").position, Vec2(3, 4));
  const World before = world;
  EXPECT_THROW(snap(world, world.ids(), 20), ArgumentError);  // the fence would shrink to a point
  EXPECT_TRUE(world == before);
}

TEST(WorldEditing, RefusesWhatIsNoTurnScaleStepNameOrDoor) {
  World world = room();
  const Id desk = world.find("desk 1");
  const World before = world;
  EXPECT_THROW(turn(world, {desk}, std::nan("")), ArgumentError);
  for (const double factor : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(scale(world, {desk}, factor), ArgumentError);
  for (const double step : {0.0, -1.0, std::nan(""), HUGE_VAL}) EXPECT_THROW(snap(world, {desk}, step), ArgumentError);
  EXPECT_THROW(move(world, {desk}, {std::nan(""), 0}), ArgumentError);
  EXPECT_THROW(rename(world, desk, ""), ArgumentError);
  EXPECT_THROW(set_open(world, desk, true), ArgumentError);
  EXPECT_TRUE(world == before);
  EXPECT_EQ(world.revision(), before.revision());
}

TEST(WorldEditing, RenamesAndOpens) {
  World world = room();
  rename(world, world.find("door"), "gate");
  set_open(world, world.find("gate"), true);
  EXPECT_TRUE(get<Door>(world, "gate").open);
  EXPECT_FALSE(world.has("door"));
}

}  // namespace
}  // namespace meander
