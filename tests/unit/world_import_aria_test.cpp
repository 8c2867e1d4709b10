// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_aria.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/angle.hpp"
#include "world/import_world.hpp"

namespace meander {
namespace {

const std::string kMap =
    "2D-Map\r\nLineMinPos: 0 0\nNumLines: 3\nCairn: RobotHome 500 1000 90.000000 \"\" ICON \"\"\n"
    "Cairn: GoalWithHeading 1500 1000 0 \"\" ICON \"desk\"\nCairn: Dock x\nLINES\n0 0 2000 0\n2000 0 2000 3000\n"
    "5 5 5 5\nDATA\n1 2\n";

TEST(AriaMap, LinesAreWallsHomeIsTheStartAndGoalsArePlaces) {
  const Imported map = aria_from_text(kMap, "hall.map");
  EXPECT_EQ(map.world.size(), 3u);
  EXPECT_EQ(map.world.header().title, "hall");
  ASSERT_TRUE(map.world.header().start);
  EXPECT_EQ(map.world.header().start->position(), Vec2(0.5, 1));
  EXPECT_NEAR(map.world.header().start->heading, kPi / 2, 1e-12);
  EXPECT_TRUE(map.world.has("goal_1"));
  EXPECT_EQ(map.report, (std::vector<std::string>{"2 walls", "1 lines without length left out"}));
}

TEST(AriaMap, WhatIsNoneIsRefusedWithItsLine) {
  const auto why = [](const std::string& text) {
    try {
      aria_from_text(text, "m.map");
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(why("type octile\n").find("m.map:1"), std::string::npos);
  EXPECT_NE(why("2D-Map\nLINES\nDATA\n").find("no walls"), std::string::npos);
  EXPECT_NE(why("2D-Map\nLINES\n0 0 1000 0\n0 0 1000\n").find("m.map:4: 4 numbers"), std::string::npos);
  EXPECT_NE(why("2D-Map\nLINES\n0 0 1e300 0\n").find("m.map:3"), std::string::npos);
  EXPECT_NE(why("2D-Map\nCairn: RobotHome 1\n").find("m.map:2: 3 numbers"), std::string::npos);
}

TEST(AriaMap, OneThatNobodyHereDrew) {
  const std::filesystem::path path = std::filesystem::path(MEANDER_SOURCE_DIR) / "../shared/data/aria_maps/Map1.map";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there: nothing was read";
  EXPECT_EQ(import_world(path.string()).world.size(), 134u);
}

}  // namespace
}  // namespace meander
