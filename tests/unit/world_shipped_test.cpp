// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// The worlds that come with the program: canonical text, free ground, ways for a Nomad 200.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "world/world_file.hpp"

namespace meander {
namespace {

constexpr double kRobotRadius = 0.2667;

std::string file(const std::string& name) { return std::string(MEANDER_SOURCE_DIR) + "/worlds/" + name + ".toml"; }

World shipped(const std::string& name) { return read_world(file(name)); }

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(MEANDER_SOURCE_DIR) + "/worlds"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

double clearance(const World& world, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Id id : world.ids())
    if (const Shape* shape = blocking_shape(world.item(id))) least = std::min(least, distance(*shape, point));
  return least;
}

std::vector<Place> places(const World& world) {
  std::vector<Place> found;
  for (const Id id : world.ids())
    if (const auto* place = std::get_if<Place>(&world.item(id))) found.push_back(*place);
  return found;
}

Vec2 place(const World& world, const std::string& name) {
  return std::get<Place>(world.item(world.find(name))).position;
}

/// Where the robot's centre may be, on a raster of 5 cm, and which of it is reached from the start.
class Reach {
 public:
  explicit Reach(const World& world) : bounds_(world.header().bounds) {
    width_ = static_cast<int>(std::ceil(bounds_.size().x() / kCell));
    height_ = static_cast<int>(std::ceil(bounds_.size().y() / kCell));
    reached_.assign(static_cast<std::size_t>(width_ * height_), 0);
    std::vector<std::pair<int, int>> open{cell(world.header().start->position())};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (i < 0 || j < 0 || i >= width_ || j >= height_ || reached_[index(i, j)]) continue;
      if (clearance(world, bounds_.low + kCell * Vec2(i + 0.5, j + 0.5)) < kRobotRadius) continue;
      reached_[index(i, j)] = 1;
      for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) open.emplace_back(i + di, j + dj);
    }
  }
  bool operator()(const Vec2& point) const {
    const auto [i, j] = cell(point);
    return reached_[index(i, j)] != 0;
  }

 private:
  static constexpr double kCell = 0.05;
  std::pair<int, int> cell(const Vec2& p) const {
    const Vec2 q = (p - bounds_.low) / kCell;
    return {static_cast<int>(q.x()), static_cast<int>(q.y())};
  }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * width_ + i); }

  Box bounds_;
  int width_ = 0, height_ = 0;
  std::vector<char> reached_;
};

/// May the robot drive straight from a to b?
bool straight_way(const World& world, const Vec2& a, const Vec2& b) {
  const int steps = static_cast<int>((b - a).norm() / 0.01) + 1;
  for (int i = 0; i <= steps; ++i)
    if (clearance(world, a + (b - a) * i / steps) < kRobotRadius) return false;
  return true;
}

class ShippedWorld : public testing::TestWithParam<std::string> {};

TEST_P(ShippedWorld, IsInCanonicalForm) {
  std::ifstream in(file(GetParam()), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(to_toml(shipped(GetParam())), text);
}

TEST_P(ShippedWorld, SaysWhatItShowsAndItsSource) {
  const Header header = shipped(GetParam()).header();
  EXPECT_FALSE(header.title.empty());
  EXPECT_NE(header.note.find("\nSource: "), std::string::npos);
}

TEST_P(ShippedWorld, StartAndPlacesHaveRoom) {
  const World world = shipped(GetParam());
  ASSERT_TRUE(world.header().start);
  EXPECT_GE(clearance(world, world.header().start->position()), 0.3);
  EXPECT_FALSE(places(world).empty());
  for (const Place& place : places(world)) EXPECT_GE(clearance(world, place.position), 0.3) << place.name;
}

TEST_P(ShippedWorld, EveryPlaceIsReachedFromTheStart) {
  const World world = shipped(GetParam());
  const Reach reached(world);
  for (const Place& place : places(world)) EXPECT_TRUE(reached(place.position)) << place.name;
}

TEST_P(ShippedWorld, IsWalledIn) {
  const World world = shipped(GetParam());
  const Reach reached(world);
  const Box bounds = world.header().bounds;
  for (double x = bounds.low.x() + 0.01; x < bounds.high.x(); x += 0.05)
    EXPECT_FALSE(reached({x, bounds.low.y() + 0.01}) || reached({x, bounds.high.y() - 0.01})) << x;
  for (double y = bounds.low.y() + 0.01; y < bounds.high.y(); y += 0.05)
    EXPECT_FALSE(reached({bounds.low.x() + 0.01, y}) || reached({bounds.high.x() - 0.01, y})) << y;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedWorld, testing::ValuesIn(shipped_names()),
                         [](const auto& name) { return name.param; });

TEST(ShippedWorlds, AreAllThere) {
  const auto names = shipped_names();
  for (const char* name : {"clutter", "doors", "four_targets", "l_corner", "lab", "labyrinth", "large_u", "maze",
                           "office", "people", "u_trap"})
    EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name;
}

TEST(ShippedWorlds, TheOfficeHasThirteenLandmarks) {
  const World office = shipped("office");
  EXPECT_EQ(places(office).size(), 13u);
  for (const char* name : {"door_a", "door_b", "hall"}) EXPECT_TRUE(office.has(name)) << name;
}

TEST(ShippedWorlds, TheLabHasTwoPeopleAndADoor) {
  const World lab = shipped("lab");
  const auto count = [&](auto kind) {
    const auto ids = lab.ids();
    return std::count_if(ids.begin(), ids.end(),
                         [&](Id id) { return std::holds_alternative<decltype(kind)>(lab.item(id)); });
  };
  EXPECT_EQ(count(Mover{}), 2);
  EXPECT_EQ(count(Door{}), 1);
}

TEST(ShippedWorlds, ObstaclesStandInTheStraightWay) {
  for (const char* name : {"u_trap", "l_corner", "large_u"}) {
    const World world = shipped(name);
    EXPECT_FALSE(straight_way(world, world.header().start->position(), place(world, "goal"))) << name;
  }
  const World four = shipped("four_targets");
  Vec2 from = four.header().start->position();
  for (const char* name : {"target_1", "target_2", "target_3", "target_4"}) {
    EXPECT_FALSE(straight_way(four, from, place(four, name))) << name;
    from = place(four, name);
  }
}

}  // namespace
}  // namespace meander
