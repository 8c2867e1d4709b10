// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "indicator/door_doubt.hpp"

namespace meander {
namespace {

constexpr double kFree = -15, kWall = 30;

Cell at(const SonarOccupancy& map, double x, double y) { return map.space().frame().cell({x, y}); }

TEST(DoorDoubt, AWallWhereItWasFreeIsDoubtedFromTimeToTimeAndNoOther) {
  SonarOccupancy map(platform("nomad200"));
  map.include({0, 0});
  map.add(at(map, 1, 1), kFree);
  map.add(at(map, 1, 2), kWall);
  DoorDoubt doors;
  doors.begin(map, 1, 3);
  map.add(at(map, 1, 1), kWall);
  doors.begin(map, 2, 3);
  EXPECT_EQ(map.space().known(at(map, 1, 1)), Known::wall);
  map.include({-30, 20});  // it grows
  doors.begin(map, 3, 3);
  EXPECT_EQ(map.space().known(at(map, 1, 1)), Known::nothing);
  EXPECT_EQ(map.space().known(at(map, 1, 2)), Known::wall);
  map.add(at(map, 1, 1), kWall);  // it is still closed
  doors.begin(map, 4, 3);
  EXPECT_EQ(map.space().known(at(map, 1, 1)), Known::wall);
  doors.begin(map, 6, 0);
  EXPECT_EQ(map.space().known(at(map, 1, 1)), Known::wall);
  doors.begin(map, 6, 3);
  EXPECT_EQ(map.space().known(at(map, 1, 1)), Known::nothing);
}

TEST(DoorDoubt, IsReadAsItWasWritten) {
  SonarOccupancy map(platform("nomad200"));
  map.include({0, 0});
  DoorDoubt doors, again;
  for (const double x : {-7.9, 0.0, 0.05, 0.1, 2.0}) map.add(at(map, x, 1), kFree);
  doors.begin(map, 1, 3);
  const std::string text = doors.lines();
  TextLines lines(text, "doors.txt");
  again.read(lines, map);
  EXPECT_EQ(again.lines(), text);
  for (const char* wrong :
       {"once 0 0\ndone\n", "once 0 0 0\ndone\n", "once 319 0 9\ndone\n", "once 0 9999 1\ndone\n", "x\n", ""}) {
    TextLines bad(wrong, "doors.txt");
    EXPECT_THROW(DoorDoubt().read(bad, map), FileError) << wrong;
  }
}

}  // namespace
}  // namespace meander
