// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Maps that nobody here drew, from the folder MEANDER_DATA (default: shared/data beside the checkout).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/text_file.hpp"
#include "grid/image_file.hpp"
#include "own_folder.hpp"
#include "world/export_ros_map.hpp"
#include "world/import_world.hpp"
#include "world_trace_laws.hpp"

namespace meander {
namespace {

namespace fs = std::filesystem;

fs::path data_folder() {
  const char* folder = std::getenv("MEANDER_DATA");
  return folder ? fs::path(folder) : fs::path(MEANDER_SOURCE_DIR) / ".." / "shared" / "data";
}

/// Cells darker than `threshold` are solid.
Raster from_image(const std::string& path, int threshold) {
  const Image image = read_image(path);
  Raster grid(image.width, image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) grid[{x, y}] = grey(image, x, image.height - 1 - y) < threshold;
  return grid;
}

Raster from_movingai(const std::string& path) {
  std::ifstream in(path);
  std::string word;
  int width = 0, height = 0;
  in >> word >> word >> word >> height >> word >> width >> word;
  Raster grid(width, height);
  for (int y = height - 1; y >= 0; --y) {
    in >> word;
    for (int x = 0; x < width; ++x)
      grid[{x, y}] = std::string(".GS").find(word[static_cast<std::size_t>(x)]) == std::string::npos;
  }
  return grid;
}

class ForeignMap : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!fs::exists(path())) GTEST_SKIP() << "NOT TESTED: no " << path();
  }
  std::string path() const { return (data_folder() / GetParam()).string(); }
};

class ForeignRaster : public ForeignMap {};

TEST_P(ForeignRaster, IsTracedFaithfullyAndWithoutLeaks) {
  const bool game = path().ends_with(".map");
  for (const int threshold : game ? std::vector{0} : std::vector{100, 230}) {  // unknown free, unknown solid
    const Raster grid = game ? from_movingai(path()) : from_image(path(), threshold);
    expect_faithful(grid, {}, path());
    expect_no_leak(grid, {}, path());
  }
}

INSTANTIATE_TEST_SUITE_P(Data, ForeignRaster,
                         testing::Values("ros_maps/depot.pgm", "ros_maps/tb3_sandbox.pgm",
                                         "ros_maps/rangelibc_basement_hallways_5cm.png", "movingai/arena.map",
                                         "movingai/den312d.map", "movingai/Berlin_0_256.map",
                                         "movingai/random512-25-0.map"));

class ForeignRosMap : public ForeignMap {};

/// Is a cell of the value within one cell?
bool near(const Grid<std::uint8_t>& grid, Cell cell, std::uint8_t value) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (grid.at({cell.x + dx, cell.y + dy}, 2) == value) return true;
  return false;
}

TEST_P(ForeignRosMap, ComesBackWithinOneCell) {
  const fs::path copy = own_folder() / "round_trip.yaml";
  for (const Unknown unknown : {Unknown::automatic, Unknown::free}) {
    const Imported first = import_ros_map(path(), {unknown, RosConvention::nav2, {}});
    const double resolution = ros_map_file(read_text_file(path(), 1 << 20), path()).resolution;
    export_ros_map(first.world, copy.string(), resolution);
    const Image image = read_image(fs::path(path()).replace_extension(".pgm").string());
    const Image again = read_image(fs::path(copy).replace_extension(".pgm").string());
    ASSERT_EQ(again.width, image.width);
    ASSERT_EQ(again.height, image.height);
    const Raster before =
        from_image(fs::path(path()).replace_extension(".pgm").string(), unknown == Unknown::free ? 100 : 230);
    const Raster after = from_image(fs::path(copy).replace_extension(".pgm").string(), 100);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const Cell cell{x, y};
        ASSERT_GE(after[cell], before[cell]) << x << ", " << y;  // nothing solid is lost
        ASSERT_TRUE(!after[cell] || near(before, cell, 1)) << x << ", " << y;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Data, ForeignRosMap, testing::Values("ros_maps/depot.yaml", "ros_maps/tb3_sandbox.yaml"));

TEST(ForeignMaps, TellTheTrapOfTheDepot) {
  const fs::path path = data_folder() / "ros_maps" / "depot.yaml";
  if (!fs::exists(path)) GTEST_SKIP() << "NOT TESTED: no " << path;
  const auto mentions = [&](Unknown unknown, const std::string& words) {
    for (const std::string& line : import_ros_map(path.string(), {unknown, RosConvention::nav2, {}}).report)
      if (line.find(words) != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(mentions(Unknown::automatic, "the 8894 cells of that grey"));
  EXPECT_TRUE(mentions(Unknown::automatic, "170587 cells free, 5947 occupied, 8894 unknown, taken as solid"));
  EXPECT_TRUE(mentions(Unknown::free, "8894 unknown, taken as free"));
  EXPECT_FALSE(mentions(Unknown::free, "warning"));
  EXPECT_FALSE(mentions(Unknown::occupied, "warning"));
}

TEST(ForeignMaps, HoldAllBarnWorlds) {
  const fs::path path = data_folder() / "barn" / "barn_000_149_static_cylinders.csv";
  if (!fs::exists(path)) GTEST_SKIP() << "NOT TESTED: no " << path;
  const std::string text = read_text_file(path.string(), 1 << 24);
  for (int index = 0; index < 150; ++index) {
    const World world = barn_from_csv(text, path.string(), {index}).world;
    EXPECT_GT(world.ids().size(), 50u) << index;
    EXPECT_EQ(world.header().start, (Pose2{-2.25, 3, kPi / 2}));
  }
  EXPECT_THROW(barn_from_csv(text, path.string(), {150}), FileError);
}

}  // namespace
}  // namespace meander
