// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <filesystem>

#include "base/text_file.hpp"
#include "grid/image_file.hpp"
#include "mapping/map_file.hpp"
#include "own_folder.hpp"

namespace meander {
namespace {

std::string file(const std::string& name) { return (own_folder() / name).string(); }

Grid<float> shades() {
  Grid<float> map(3, 2, 0.5F, {0.05, {-1.5, 0.25, 0}});
  map[{0, 0}] = 0.02F;
  map[{1, 0}] = 0.3F;
  map[{2, 1}] = 0.97F;
  return map;
}

TEST(MapFile, RosMapHasThreeShadesAndItsPlace) {
  save_map(shades(), file("a \"map\".yaml"));
  const std::string yaml = read_text_file(file("a \"map\".yaml"), 10000);
  EXPECT_NE(yaml.find("image: \"a \\\"map\\\".pgm\"\n"), std::string::npos) << yaml;
  EXPECT_NE(yaml.find("origin: [-1.5, 0.25, 0]"), std::string::npos) << yaml;
  const Image image = read_image(file("a \"map\".pgm"));
  EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{205, 205, 0, 254, 205, 205}));
}

TEST(MapFile, ImagesKeepAllShades) {
  for (const char* name : {"m.pgm", "m.png"}) {
    save_map(shades(), file(name));
    const Image image = read_image(file(name));
    EXPECT_EQ(grey(image, 2, 0), 8);
    EXPECT_EQ(grey(image, 0, 1), 250);
    EXPECT_EQ(grey(image, 1, 1), 179);
  }
}

TEST(MapFile, SaysWhatCannotBeWritten) {
  EXPECT_THROW(save_map(shades(), file("m.txt")), FileError);
  EXPECT_THROW(save_map(Grid<float>(), file("empty.png")), ArgumentError);
  EXPECT_FALSE(std::filesystem::exists(file("empty.png")));
}

}  // namespace
}  // namespace meander
