// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/movingai.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace meander {
namespace {

const std::string kMap = "type octile\nheight 3\nwidth 4\nmap\n....\n.@T.\nSWGg\n";

template <class Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const FileError& error) {
    return error.what();
  }
  return "none";
}
std::string map_complaint(const std::string& text) {
  return complaint([&] { movingai_map(text, "m"); });
}
std::string task_complaint(const std::string& line) {
  return complaint([&] { movingai_scenarios("version 1\n" + line, "s", 4, 3); });
}

TEST(MovingAi, FirstRowIsTheTop) {
  const MovingAiMap map = movingai_map(kMap, "m");
  EXPECT_EQ(map.blocked.cells(), (std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(map.water, 1u);
  EXPECT_EQ(map.swamp, 1u);
}

TEST(MovingAi, SaysWhatIsWrongWithAMap) {
  EXPECT_EQ(map_complaint("2D-Map\nLINES"), "m:1: 'type octile' expected, got '2D-Map'");
  EXPECT_EQ(map_complaint("type octile\nwidth 4\n"), "m:2: 'height N' expected, got 'width 4'");
  EXPECT_EQ(map_complaint("type octile\nheight 0\n"), "m:2: 'height N' expected, got 'height 0'");
  EXPECT_EQ(map_complaint("type octile\nheight 3\nwidth 4\n....\n....\n....\n"), "m:4: 'map' expected, got '....'");
  EXPECT_EQ(map_complaint("type octile\nheight 9999\nwidth 9999\nmap\n"),
            "m: 9999 x 9999 cells promised, more than the file has");
  EXPECT_EQ(map_complaint("type octile\nheight 2\nwidth 4\nmap\n....\n...\n"),
            "m:6: a row of 4 cells expected, got '...'");
  EXPECT_EQ(map_complaint(kMap + "....\n"), "m:8: nothing more expected, got '....'");
  EXPECT_EQ(map_complaint(kMap + "\n"), "none");
}

TEST(MovingAi, ReadsScenarios) {
  const auto tasks = movingai_scenarios("version 1.0\n3 maps/a.map 4 3 0 0 3 2 4.41421356\n\n", "s", 4, 3);
  ASSERT_EQ(tasks.size(), 1u);
  EXPECT_EQ(tasks[0].bucket, 3);
  EXPECT_EQ(tasks[0].map, "maps/a.map");
  EXPECT_EQ(tasks[0].start, (Cell{0, 2}));
  EXPECT_EQ(tasks[0].goal, (Cell{3, 0}));
  EXPECT_DOUBLE_EQ(tasks[0].length, 4.41421356);
}

TEST(MovingAi, SaysWhatIsWrongWithScenarios) {
  EXPECT_EQ(complaint([] { movingai_scenarios("0 a 4 3 0 0 1 1 1\n", "s", 4, 3); }),
            "s:1: 'version 1' expected, got '0 a 4 3 0 0 1 1 1'");
  EXPECT_EQ(task_complaint("0 a 4 3 0 0 1 1"),
            "s:2: bucket, map, width, height, start x y, goal x y, length expected, got '0 a 4 3 0 0 1 1'");
  EXPECT_EQ(task_complaint("0 a 4 3 0 0 4 1 1"), "s:2: a cell inside of the map expected, got '0 a 4 3 0 0 4 1 1'");
  EXPECT_EQ(task_complaint("0 a 8 3 0 0 1 1 1"), "s:2: the size 4 x 3 of the map expected, got '0 a 8 3 0 0 1 1 1'");
  EXPECT_EQ(task_complaint("0 a 4 3 0 0 1 1 nan"), "s:2: a length expected, got '0 a 4 3 0 0 1 1 nan'");
}

}  // namespace
}  // namespace meander
