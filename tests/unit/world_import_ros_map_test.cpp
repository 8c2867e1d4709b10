// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/import_ros_map.hpp"

#include <gtest/gtest.h>

#include <array>

#include "base/random.hpp"
#include "world/export_ros_map.hpp"
#include "world/rasterize.hpp"
#include "world_import_support.hpp"

namespace meander {
namespace {

using Values = std::vector<std::int8_t>;

RosMapFile thresholds(double free, double occupied, RosMapMode mode = RosMapMode::trinary) {
  RosMapFile file;
  file.resolution = 0.1;
  file.free_thresh = free;
  file.occupied_thresh = occupied;
  file.mode = mode;
  return file;
}

/// Writes a map of one image and imports it.
Imported imported(const Image& image, const std::string& more, const RosMapOptions& options = {}) {
  write_image(scratch("map.png"), image);
  return import_ros_map(written("map.yaml", "image: map.png\nresolution: 0.1\nnegate: 0\n" + more), options);
}

const std::string kPlain = "origin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
const std::string kTrap = "origin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";

TEST(RosOccupancy, ComparesInclusivelyForNav2AndStrictlyForRos1) {
  const Image image = strip({0, 51, 102, 153, 204, 255});  // p = 1, 0.8, 0.6, 0.4, 0.2, 0
  EXPECT_EQ(ros_occupancy(thresholds(0.2, 0.8), image, RosConvention::nav2).cells(), (Values{100, 100, -1, -1, 0, 0}));
  EXPECT_EQ(ros_occupancy(thresholds(0.2, 0.8), image, RosConvention::ros1).cells(), (Values{100, -1, -1, -1, -1, 0}));
}

TEST(RosOccupancy, KnowsTheModes) {
  const Image image = strip({0, 51, 102, 153, 204, 255});
  EXPECT_EQ(ros_occupancy(thresholds(0.2, 0.8, RosMapMode::scale), image, RosConvention::nav2).cells(),
            (Values{100, 100, 67, 33, 0, 0}));
  EXPECT_EQ(ros_occupancy(thresholds(0.2, 0.8, RosMapMode::scale), image, RosConvention::ros1).cells(),
            (Values{100, 99, 66, 33, 1, 0}));
  EXPECT_EQ(
      ros_occupancy(thresholds(0.2, 0.8, RosMapMode::raw), strip({0, 50, 100, 101, 255}), RosConvention::nav2).cells(),
      (Values{0, 50, 100, -1, -1}));
}

TEST(RosOccupancy, NegatesValuesNotThresholds) {
  RosMapFile file = thresholds(0.25, 0.65);
  file.negate = true;
  EXPECT_EQ(ros_occupancy(file, strip({0, 128, 255}), RosConvention::nav2).cells(), (Values{0, -1, 100}));
}

TEST(RosOccupancy, TakesSeeThroughPixelsAsTheConventionDoes) {
  const Image image{2, 1, 4, {0, 0, 0, 255, 0, 0, 0, 0}};
  EXPECT_EQ(ros_occupancy(thresholds(0.2, 0.65), image, RosConvention::nav2).cells(), (Values{100, -1}));
  EXPECT_EQ(ros_occupancy(thresholds(0.2, 0.65), image, RosConvention::ros1).cells(), (Values{100, 100}));
}

TEST(RosOccupancy, PutsTheFirstImageRowOnTop) {
  const Image image{1, 2, 1, {0, 254}};
  EXPECT_EQ(ros_occupancy(thresholds(0.2, 0.65), image, RosConvention::nav2).cells(), (Values{0, 100}));
}

TEST(ImportRosMap, HandlesUnknownCellsAsAsked) {
  const Image image = strip({254, 205, 205, 254, 0});
  for (const std::string& yaml : {kPlain, kTrap})
    for (const Unknown unknown : {Unknown::automatic, Unknown::occupied, Unknown::free}) {
      const Imported result = imported(image, yaml, {unknown, RosConvention::nav2, {}});
      const bool solid = unknown != Unknown::free;
      EXPECT_TRUE(mentions(result.report, "2 cells free, 1 occupied, 2 unknown, taken as "));
      EXPECT_EQ(rasterize(result.world, 0.1).cells(), (std::vector<std::uint8_t>{0, solid, solid, 0, 1}));
    }
}

TEST(ImportRosMap, WarnsOfTheFreeThresholdTrapInWords) {
  const Image image = strip({254, 205, 205, 254, 0});
  const Imported trapped = imported(image, kTrap);
  EXPECT_TRUE(mentions(trapped.report, "warning: free_thresh 0.25 is above 0.19608, the value of grey 205"));
  EXPECT_TRUE(mentions(trapped.report, "the 2 cells of that grey"));
  EXPECT_FALSE(mentions(imported(image, kPlain).report, "warning"));
  EXPECT_FALSE(mentions(imported(strip({254, 206, 0}), kTrap).report, "warning"));
}

TEST(ImportRosMap, HonoursTheOriginAndItsYaw) {
  const Imported result = imported(Image{2, 2, 1, {0, 254, 254, 254}},  // the upper left cell
                                   "origin: [10, 20, 1.5707963267948966]\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  ASSERT_EQ(result.world.ids().size(), 1u);
  const Shape shape = *blocking_shape(result.world.item(result.world.ids()[0]));
  EXPECT_LT((center(shape) - Vec2(9.85, 20.05)).norm(), 1e-9);
  EXPECT_LT((result.world.header().bounds.low - Vec2(9.8, 20)).norm(), 1e-9);
  EXPECT_LT((result.world.header().bounds.high - Vec2(10, 20.2)).norm(), 1e-9);
}

TEST(ImportRosMap, StartsWithAnEmptyHistory) {
  World world = imported(strip({254, 0, 254}), kPlain).world;
  EXPECT_EQ(world.undo(), 0);
  EXPECT_EQ(world.header().title, "map");
}

TEST(ImportRosMap, NamesTheFileThatIsMissing) {
  EXPECT_NE(message([] { import_ros_map(scratch("nowhere.yaml")); }).find("nowhere.yaml: no such file"),
            std::string::npos);
  const std::string path = written("lost.yaml", "image: lost.pgm\nresolution: 0.1\n" + kPlain);
  EXPECT_NE(message([&] { import_ros_map(path); }).find("lost.pgm: no such file"), std::string::npos);
}

TEST(ExportRosMap, LosesNoSolidCell) {
  Stream stream(3, "maps");
  for (int i = 0; i < 20; ++i) {
    Image image{5 + stream.below(30), 5 + stream.below(30), 1, {}};
    for (int n = image.width * image.height; n > 0; --n) image.pixels.push_back(stream.chance(0.3) ? 0 : 254);
    // Without straightening the outlines keep to the cells but for cut corners, so the same cells come back.
    const World world = imported(image, kPlain, {Unknown::automatic, RosConvention::nav2, {0, 0}}).world;
    export_ros_map(world, scratch("again's.yaml"), 0.1);
    EXPECT_EQ(rasterize(import_ros_map(scratch("again's.yaml")).world, 0.1).width(), image.width);
    const Image again = read_image(scratch("again's.pgm"));
    ASSERT_EQ(again.pixels.size(), image.pixels.size());
    for (std::size_t c = 0; c < image.pixels.size(); ++c)
      EXPECT_LE(again.pixels[c], image.pixels[c]) << "a solid cell is lost";
  }
}

TEST(ExportRosMap, GivesBackRightAngledWallsExactly) {
  Image image{40, 30, 1, std::vector<std::uint8_t>(1200, 254)};
  const auto block = [&](int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) image.pixels[static_cast<std::size_t>(40 * y + x)] = 0;
  };
  for (const auto& [x0, y0, x1, y1] : {std::array{0, 0, 40, 1},
                                       {0, 29, 40, 30},
                                       {0, 0, 1, 30},
                                       {39, 0, 40, 30},
                                       {12, 1, 14, 20},
                                       {25, 8, 26, 29},
                                       {30, 4, 34, 9},
                                       {5, 24, 6, 25}})
    block(x0, y0, x1, y1);
  const World world = imported(image, "origin: [-3, 7.7, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.196\n").world;
  export_ros_map(world, scratch("walls.yaml"), 0.1);
  EXPECT_EQ(read_image(scratch("walls.pgm")), image);
  EXPECT_EQ(import_ros_map(scratch("walls.yaml")).world.header().bounds.low, Vec2(-3, 7.7));
}

TEST(ExportRosMap, RefusesBadNamesAndSizes) {
  const World world;
  EXPECT_NE(message([&] { export_ros_map(world, scratch("a.txt")); }).find("suffix .yaml"), std::string::npos);
  EXPECT_NE(message([&] { export_ros_map(world, scratch("a.yaml"), 0); }).find("resolution > 0"), std::string::npos);
  EXPECT_NE(message([&] { export_ros_map(world, scratch("a.yaml"), 1e-4); }).find("at most"), std::string::npos);
}

}  // namespace
}  // namespace meander
