// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include "world/import_world.hpp"
#include "world/rasterize.hpp"
#include "world/world_file.hpp"
#include "world_import_support.hpp"

namespace meander {
namespace {

using Cells = std::vector<std::uint8_t>;

const std::string kTable =
    "world,x_m,y_m,radius_m\n3,-0.5,5,0.075\n3,-0.6,5,0.075\n3,-0.5,5,0.075\n4,1,2,0.5\n7,1,2,0.5\n";

TEST(ImportFloorPlan, ChoosesTheThresholdByOtsu) {
  write_image(scratch("plan.png"), strip({220, 40, 230, 60, 210}));
  const Imported result = import_floor_plan(scratch("plan.png"), {0.5, 0, false, {}});
  EXPECT_EQ(rasterize(result.world, 0.5).cells(), (Cells{0, 1, 0, 1, 0}));
  EXPECT_TRUE(mentions(result.report, "plan.png: 5 x 1 cells of 0.5 m, 2.5 m x 0.5 m"));
  EXPECT_TRUE(mentions(result.report, "chosen by Otsu's method"));
  EXPECT_TRUE(mentions(result.report, "2 solids with 8 edges and 0 holes; 0 specks dropped"));
}

TEST(ImportFloorPlan, TakesThresholdAndNegation) {
  write_image(scratch("plan.png"), strip({220, 40, 230, 100, 210}));
  EXPECT_EQ(rasterize(import_floor_plan(scratch("plan.png"), {1, 50, false, {}}).world, 1).cells(),
            (Cells{0, 1, 0, 0, 0}));
  EXPECT_EQ(rasterize(import_floor_plan(scratch("plan.png"), {1, 50, true, {}}).world, 1).cells(),
            (Cells{1, 0, 1, 1, 1}));
  const Imported dark = import_floor_plan(scratch("plan.png"), {1, 225, false, {}});
  EXPECT_TRUE(mentions(dark.report, "warning: more than half of the picture is wall"));
}

TEST(ImportFloorPlan, PutsYUpAndPaperBehindSeeThroughPixels) {
  write_image(scratch("plan.png"), Image{1, 3, 4, {0, 0, 0, 255, 0, 0, 0, 0, 255, 255, 255, 255}});
  EXPECT_EQ(rasterize(import_floor_plan(scratch("plan.png"), {1, 0, false, {}}).world, 1).cells(), (Cells{0, 0, 1}));
}

TEST(ImportFloorPlan, CountsSpecksAndBlankPictures) {
  write_image(scratch("plan.png"), strip({255, 0, 255, 0, 0, 255}));
  EXPECT_TRUE(mentions(import_floor_plan(scratch("plan.png"), {1, 0, false, {0.49, 1.5}}).report, "1 speck dropped"));
  write_image(scratch("blank.png"), strip({255, 255, 255}));
  EXPECT_TRUE(
      mentions(import_floor_plan(scratch("blank.png"), {1, 128, false, {}}).report, "warning: nothing is solid"));
  EXPECT_TRUE(
      mentions(import_floor_plan(scratch("blank.png"), {1, 128, true, {}}).report, "warning: everything is solid"));
}

TEST(ImportFloorPlan, RefusesOptionsOutOfRange) {
  EXPECT_THROW(import_floor_plan("plan.png", {0, 0, false, {}}), ArgumentError);
  EXPECT_THROW(import_floor_plan("plan.png", {1, 300, false, {}}), ArgumentError);
}

TEST(ImportBarn, MakesDiscsStartAndGoal) {
  const Imported result = barn_from_csv(kTable, "barn.csv", {3});
  EXPECT_EQ(result.world.ids().size(), 3u);  // the goal and two discs: the third repeats the first
  EXPECT_TRUE(mentions(result.report, "world 3 of 3, 4, 7: 2 cylinders, 1 repeated ones dropped"));
  EXPECT_EQ(result.world.header().start, (Pose2{-2.25, 3, kPi / 2}));
  const auto& goal = std::get<Place>(result.world.item(result.world.find("goal")));
  EXPECT_LT((goal.position - Vec2(-2.25, 13)).norm(), 1e-12);
  const auto disc = std::get<Disc>(*blocking_shape(result.world.item(result.world.find("obstacle 2"))));
  EXPECT_EQ(disc, (Disc{{-0.5, 5}, 0.075}));
}

TEST(ImportBarn, FindsColumnsByName) {
  const World world = barn_from_csv("radius_m,note,world,y_m,x_m\r\n0.1, pole ,0,5,1\r\n\r\n", "barn.csv").world;
  EXPECT_EQ(std::get<Disc>(*blocking_shape(world.item(world.find("obstacle 2")))), (Disc{{1, 5}, 0.1}));
}

TEST(ImportBarn, SaysWhatIsWrongAndWhere) {
  const std::pair<std::string, const char*> cases[] = {
      {kTable, "barn.csv: no world 0; there are 3, 4, 7"},
      {"world,x_m,y_m,radius_m\n1,0,0,1\n2,0,0,1\n", "no world 0; there are 1 to 2"},
      {"world,x_m,y_m\n0,1,2\n", "barn.csv:1: a head line with the columns world, x_m, y_m, radius_m expected"},
      {"", "a head line"},
      {"world,x_m,y_m,radius_m\n0,1,two,0.1\n", "barn.csv:2: column 'y_m': a position [m] expected, got 'two'"},
      {"world,x_m,y_m,radius_m\n0,1,2,-0.1\n", "column 'radius_m': a radius > 0 [m] expected, got '-0.1'"},
      {"world,x_m,y_m,radius_m\n0.5,1,2,0.1\n", "column 'world': a whole number"},
      {"world,x_m,y_m,radius_m\n\n0,1,2\n", "barn.csv:3: 4 values expected, got 3"},
      {"world,x_m,y_m,radius_m\n0,-2.25,3,0.5\n", "start"}};
  for (const auto& [text, expected] : cases) {
    const std::string got = message([&, &table = text] { barn_from_csv(table, "barn.csv"); });
    EXPECT_NE(got.find(expected), std::string::npos) << text << " -> " << got;
  }
}

TEST(ImportWorld, PicksTheFormatByTheSuffix) {
  write_image(scratch("plan.png"), strip({255, 0, 255}));
  write_image(scratch("PLAN.pgm"), strip({255, 0, 255}));
  const std::string yaml = written("plan.yml",
                                   "image: plan.png\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
                                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  written("barn.csv", kTable);
  ImportOptions options;
  options.index = 4;
  options.resolution = 0.5;
  const World plan = import_world(scratch("plan.png"), options).world;
  write_world(scratch("plan.toml"), plan);
  EXPECT_EQ(import_world(scratch("plan.toml")).world, plan);
  EXPECT_EQ(import_world(yaml).world.ids().size(), plan.ids().size());
  EXPECT_EQ(import_world(scratch("PLAN.pgm"), options).world.header().bounds, plan.header().bounds);
  EXPECT_EQ(import_world(scratch("barn.csv"), options).world.ids().size(), 2u);
}

TEST(ImportWorld, ListsWhatItKnows) {
  const std::string text = message([] { import_world("map.svg"); });
  EXPECT_NE(text.find("map.svg: a file of a known format (.toml, .yaml, .yml, .png,"), std::string::npos) << text;
  for (const std::string& suffix : import_suffixes()) EXPECT_NE(text.find(suffix), std::string::npos);
  EXPECT_NE(message([] { import_world("nowhere.png"); }).find("nowhere.png: no such file"), std::string::npos);
}

}  // namespace
}  // namespace meander
