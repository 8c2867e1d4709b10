// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/draw_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/random.hpp"
#include "render/draw_cells.hpp"
#include "render/draw_parts.hpp"
#include "render/draw_run.hpp"
#include "render/terminal.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Header header(double width, double height) {
  Header h;
  h.title = "test";
  h.bounds = {{0, 0}, {width, height}};
  return h;
}

int count(const DrawList& list, Mark mark) {
  return static_cast<int>(
      std::count_if(list.items.begin(), list.items.end(), [&](const DrawItem& item) { return mark_of(item) == mark; }));
}

std::vector<std::string> texts(const DrawList& list) {
  std::vector<std::string> all;
  for (const DrawItem& item : list.items)
    if (const DrawText* text = std::get_if<DrawText>(&item)) all.push_back(text->text);
  return all;
}

bool has(const std::vector<std::string>& all, const std::string& text) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

World furnished() {
  Header h = header(10, 8);
  h.start = Pose2{1, 1, 0.5};
  World world(h);
  world.add(Obstacle{"box", Rectangle{{5, 2}, {1, 1}, 0.3}, {}});
  world.add(Obstacle{"pole", Disc{{8, 2}, 0.2}, {}});
  world.add(Obstacle{"l", Polygon{{{3, 5}, {5, 5}, {5, 6}, {4, 6}, {4, 7}, {3, 7}}, {}}, {}});
  world.add(Obstacle{"wire", Chain{{{7, 5}, {9, 5}, {9, 7}}, false}, {}});
  world.add(Door{"shut", Rectangle{{2, 4}, {1, 0.1}, 0}, false, {}});
  world.add(Door{"gap", Rectangle{{6, 4}, {1, 0.1}, 0}, true, {}});
  world.add(Mover{"cat", {{2, 6}, 0.2}, Motion::waypoints, {{2, 7}}, 0.5, true});
  world.add(Light{"lamp", {7, 7}, 1});
  world.add(Place{"desk", {8, 4}, 0.5, 0.25});
  return world;
}

TEST(DrawWorld, EveryKindHasItsMark) {
  const DrawList list = draw_world(furnished());
  EXPECT_EQ(count(list, Mark::wall), 4);
  EXPECT_EQ(count(list, Mark::door), 1);
  EXPECT_GT(count(list, Mark::open_door), 4);  // dashes
  EXPECT_EQ(count(list, Mark::mover), 1);
  EXPECT_GT(count(list, Mark::light), 0);
  EXPECT_GT(count(list, Mark::place), 0);
  EXPECT_GT(count(list, Mark::start), 0);
  for (const char* name : {"desk", "test", "2 m"}) EXPECT_TRUE(has(texts(list), name)) << name;
  for (const DrawItem& item : list.items) EXPECT_TRUE(drawable(item));
}

TEST(DrawWorld, TheLookLeavesThingsOut) {
  const World world = furnished();
  EXPECT_FALSE(has(texts(draw_world(world, {.names = false})), "desk"));
  EXPECT_EQ(count(draw_world(world, {.movers = false}), Mark::mover), 0);
  const DrawList bare = draw_world(world, {.names = false, .grid = false, .scale = false});
  EXPECT_TRUE(texts(bare).empty());
  EXPECT_EQ(count(bare, Mark::grid), 1);  // the bounds stay
  EXPECT_NE(draw_world(world, {.background = Background::dark}).background, draw_world(world).background);
}

TEST(DrawWorld, AnyBoundsGiveAFewGridLinesAndAViewAroundThem) {
  Stream random(1, "bounds");
  for (int round = 0; round < 300; ++round) {
    const Vec2 low(random.uniform(-1e4, 1e4), random.uniform(-1e4, 1e4));
    const Vec2 size(std::pow(10, random.uniform(-2, 5)), std::pow(10, random.uniform(-2, 5)));
    const DrawList list = draw_floor({low, low + size}, "", {});
    ASSERT_LE(count(list, Mark::grid), 50);
    ASSERT_TRUE(list.view.contains(low) && list.view.contains(low + size));
    for (const DrawItem& item : list.items) ASSERT_TRUE(drawable(item));
  }
}

TEST(DrawWorld, ShippedWorldsCanBeSeenInAPlainTerminal) {
  int seen = 0;
  for (const auto& file : std::filesystem::directory_iterator(MEANDER_SOURCE_DIR "/worlds")) {
    if (file.path().extension() != ".toml") continue;
    const DrawList list = draw_world(read_world(file.path().string()));
    const std::string picture = text(terminal_frame(list, {80, 24}, TerminalMode::ascii));
    EXPECT_GT(std::count(picture.begin(), picture.end(), '#'), 100) << file.path() << "\n" << picture;
    EXPECT_NE(picture.find('S'), std::string::npos) << file.path() << "\n" << picture;
    ++seen;
  }
  EXPECT_GE(seen, 7);
}

TEST(DrawTrack, ADriveInAsciiIsThis) {
  WorldLook look;
  look.scale = false;
  DrawList list = draw_floor({{0, 0}, {19, 9}}, "", look);
  list.view = {{0, 0}, {20, 10}};
  std::vector<Pose2> poses;
  for (int i = 0; i <= 140; ++i) poses.push_back({2.5 + 0.1 * i, 5, 0});
  const std::vector<TrackGoal> goals{{{10.5, 5}, 0.7, true}};
  const std::vector<Vec2> contacts{{6.5, 5}};
  draw_track(list, {poses, 0.9, goals, contacts}, theme(Background::light));
  const Frame frame = terminal_frame(list, {20, 5}, TerminalMode::ascii);
  EXPECT_EQ(frame.at(4, 2).code, U'.');
  EXPECT_EQ(frame.at(6, 2).code, U'x');
  EXPECT_EQ(frame.at(10, 2).code, U'1');
  EXPECT_EQ(frame.at(16, 2).code, U'>');
  EXPECT_EQ(frame.at(4, 0).code, U' ');
}

TEST(DrawTrack, GapsSplitTheWay) {
  const std::vector<Pose2> poses{{0, 0, 0}, {1, 0, 0}, {kNan, 0, 0}, {2, 0, 0}, {3, 0, 0}, {kNan, 0, 0}, {9, 9, 0}};
  DrawList list;
  list.view = {{0, 0}, {10, 10}};
  draw_track(list, {poses, 0.2, {}, {}}, theme(Background::light));
  EXPECT_EQ(count(list, Mark::path), 2);
  EXPECT_EQ(count(list, Mark::sweep), 2);
}

TEST(DrawTrack, NothingDrivenIsNothingDrawn) {
  DrawList list;
  draw_track(list, {}, theme(Background::light));
  EXPECT_TRUE(list.items.empty());
}

TEST(DrawReadings, OnlyEchoesHaveArcs) {
  const std::vector<Pose2> transducers(4, Pose2{1, 1, 0});
  const std::vector<double> ranges{1.0, 6.5, 2.0, kNan};
  DrawList list;
  draw_readings(list, {transducers, ranges, 0.2, 6.5}, theme(Background::light));
  EXPECT_EQ(count(list, Mark::cone), 4);
  EXPECT_EQ(count(list, Mark::echo), 2);
  EXPECT_EQ(painting_order(list).size(), 5u);  // the cone without a range is left out
}

TEST(DrawReadings, ConesReachAsFarAsTheReading) {
  const std::vector<Pose2> transducers{{1, 2, 0.7}};
  const std::vector<double> ranges{3.0};
  DrawList list;
  draw_readings(list, {transducers, ranges, 0.2, 6.5}, theme(Background::light));
  for (const Vec2& p : std::get<DrawPolyline>(list.items.back()).points) {
    EXPECT_NEAR((p - Vec2(1, 2)).norm(), 3, 1e-9);
    EXPECT_LE(std::abs(angle_between(0.7, angle_of(p.y() - 2, p.x() - 1))), 0.2 + 1e-9);
  }
}

TEST(DrawReadings, CountsMustAgree) {
  const std::vector<double> ranges(3, 1.0);
  DrawList list;
  EXPECT_THROW(draw_readings(list, {{}, ranges, 0.2, 6.5}, theme(Background::light)), ArgumentError);
}

TEST(DrawGrid, ShowsFloorAndWalls) {
  Grid<std::uint8_t> grid(3, 2, 0, {0.5, {1, 1, 0}});
  grid[{2, 1}] = 255;
  DrawList list;
  const Theme& colors = theme(Background::light);
  draw_grid(list, grid, colors);
  const DrawCells& cells = std::get<DrawCells>(list.items.at(0));
  EXPECT_EQ(cells.colors.front(), colors.floor);
  EXPECT_EQ(cells.colors.back(), colors.wall);
  EXPECT_EQ(cells.marks.back(), Mark::wall);
  list.view = {{1, 1}, {2.5, 2}};
  EXPECT_EQ(text(terminal_frame(list, {3, 1}, TerminalMode::ascii)), "  #\n");
}

TEST(DrawParts, RoundLengthsAreOneTwoOrFive) {
  Stream random(4, "lengths");
  for (int round = 0; round < 1000; ++round) {
    const double most = std::pow(10, random.uniform(-6, 6));
    const double length = round_length(most);
    ASSERT_LE(length, most * (1 + 1e-12));
    ASSERT_GT(length * 2.5, most * (1 - 1e-12));
    const double digit = length / std::pow(10, std::floor(std::log10(length * (1 + 1e-9))));
    ASSERT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6) << digit;
  }
}

TEST(DrawParts, DashesCoverHalfTheWay) {
  Stream random(5, "dashes");
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec2> way;
    double length = 0;
    for (int i = 0; i < 2 + random.below(6); ++i) {
      way.emplace_back(random.uniform(0, 10), random.uniform(0, 10));
      if (i > 0) length += (way[way.size() - 1] - way[way.size() - 2]).norm();
    }
    DrawList list;
    draw_dashed(list, way, false, 0.1, 0.01, {}, Mark::wall);
    double drawn = 0;
    for (const DrawItem& item : list.items) {
      const auto& points = std::get<DrawPolyline>(item).points;
      for (std::size_t i = 1; i < points.size(); ++i) drawn += (points[i] - points[i - 1]).norm();
    }
    ASSERT_NEAR(drawn, 0.5 * length, 0.1);
  }
}

TEST(Theme, MeaningsStayApartWithoutColourVision) {
  // Relative luminance of Rec. 709 on the coded values: walls, floor and what moves must differ in lightness alone.
  const auto lightness = [](Color c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
  for (const Background background : {Background::light, Background::dark}) {
    const Theme& t = theme(background);
    for (const Color color : {t.wall, t.path, t.robot, t.goal, t.contact, t.label, t.door})
      EXPECT_GT(std::abs(lightness(color) - lightness(t.floor)), 70) << to_string(background);
    EXPECT_GT(std::abs(lightness(t.wall) - lightness(t.robot)), 25);
    EXPECT_GT(std::abs(lightness(t.robot) - lightness(t.robot_nose)), 100);
  }
}

}  // namespace
}  // namespace meander
