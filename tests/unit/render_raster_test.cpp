// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/raster.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/random.hpp"
#include "render/picture_file.hpp"

namespace meander {
namespace {

constexpr Color kRed{255, 0, 0};
constexpr Color kBlue{0, 0, 255};

DrawList square(double side) {
  DrawList list;
  list.view = {{0, 0}, {side, side}};
  return list;
}

Color pixel(const Image& image, int x, int y) {
  const auto at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
}

TEST(Raster, SizeFollowsTheView) {
  DrawList list;
  list.view = {{0, 0}, {4, 1}};
  EXPECT_EQ(raster(list, {100, 0}).height, 25);
  EXPECT_EQ(raster(list, {100, 10}).width, 40);
  EXPECT_EQ(raster(list, {100, 10}).height, 10);
  EXPECT_EQ(raster(list, {1, 0}).height, 1);
  list.view = {{0, 0}, {1e-6, 1e6}};
  const Image thin = raster(list, {10, 20});
  EXPECT_EQ(thin.width, 1);
  EXPECT_EQ(thin.height, 20);
}

TEST(Raster, AbsurdSizesAreRefused) {
  const DrawList list = square(1);
  EXPECT_THROW(raster(list, {0, 0}), ArgumentError);
  EXPECT_THROW(raster(list, {-5, 0}), ArgumentError);
  EXPECT_THROW(raster(list, {100'000, 0}), ArgumentError);
  try {
    raster(list, {16'000, 0});
    FAIL();
  } catch (const ArgumentError& error) {
    EXPECT_STREQ(error.what(), "picture: at most 25 million pixels expected, got 16000 x 16000");
  }
}

TEST(Raster, YPointsUp) {
  DrawList list = square(10);
  list.items.emplace_back(DrawArea{{{{0, 0}, {10, 0}, {10, 5}, {0, 5}}, {}}, kRed});
  const Image image = raster(list, {20, 0});
  EXPECT_EQ(pixel(image, 10, 15), kRed);
  EXPECT_EQ(pixel(image, 10, 4), (Color{255, 255, 255}));
}

TEST(Raster, LaterMarksCoverEarlierOnesWhateverTheOrder) {
  DrawList list = square(10);
  list.items.emplace_back(DrawDisc{{{5, 5}, 3}, kBlue, Mark::robot});
  list.items.emplace_back(DrawDisc{{{5, 5}, 4}, kRed, Mark::wall});
  EXPECT_EQ(pixel(raster(list, {50, 0}), 25, 25), kBlue);
}

TEST(Raster, HolesStayOpenAndOpacityBlends) {
  DrawList list = square(10);
  list.items.emplace_back(
      DrawArea{{{{1, 1}, {9, 1}, {9, 9}, {1, 9}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}}, {255, 0, 0, 51}});
  const Image image = raster(list, {100, 0});
  EXPECT_EQ(pixel(image, 50, 50), (Color{255, 255, 255}));
  EXPECT_EQ(pixel(image, 20, 50), (Color{255, 204, 204}));
}

TEST(Raster, HairlinesAreSeen) {
  Stream random(1, "hairlines");
  for (int round = 0; round < 100; ++round) {
    DrawList list = square(1000);
    const double x = random.uniform(5, 995);
    list.items.emplace_back(DrawPolyline{{{x, 0}, {x, 1000}}, false, 0, {0, 0, 0}});
    const Image image = raster(list, {40, 0});
    int ink = 0;
    for (int column = 0; column < 40; ++column) ink += 255 - pixel(image, column, 20).r;
    EXPECT_GT(ink, 255);
    EXPECT_LT(ink, 3 * 255);
  }
}

TEST(Raster, CellsLieWhereTheirFrameSays) {
  DrawList list = square(4);
  list.items.emplace_back(DrawCells{{3, 1, kPi / 2}, 1, 2, 1, {kRed, kBlue}, {}});  // runs upwards from (3, 1)
  const Image image = raster(list, {40, 0});
  EXPECT_EQ(pixel(image, 25, 25), kRed);
  EXPECT_EQ(pixel(image, 25, 15), kBlue);
  EXPECT_EQ(pixel(image, 35, 15), (Color{255, 255, 255}));
}

TEST(Raster, FarPointsDrawWhatTheirNearPartsWould) {
  DrawList far = square(10), near = square(10);
  far.items.emplace_back(DrawArea{{{{2, -1e9}, {8, -1e9}, {8, 1e9}, {2, 1e9}}, {}}, kRed});
  near.items.emplace_back(DrawArea{{{{2, -5}, {8, -5}, {8, 15}, {2, 15}}, {}}, kRed});
  far.items.emplace_back(DrawPolyline{{{-1e9, 5}, {1e9, 5}}, false, 0.5, kBlue});
  near.items.emplace_back(DrawPolyline{{{-5, 5}, {15, 5}}, false, 0.5, kBlue});
  EXPECT_EQ(raster(far, {64, 0}), raster(near, {64, 0}));
}

TEST(Raster, NastyItemsAreHarmless) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Stream random(9, "nasty");
  const double odd[] = {kNan, std::numeric_limits<double>::infinity(), -1e300, 1e300, 1e11, -1e11, 0, 1e-300, 0.5, -3};
  const auto value = [&] { return odd[random.below(10)]; };
  const auto point = [&] { return Vec2(value(), value()); };
  for (int round = 0; round < 400; ++round) {
    DrawList list = square(1);
    list.items.emplace_back(DrawPolyline{{point(), point(), point()}, random.chance(0.5), value(), kRed});
    list.items.emplace_back(DrawArea{{{point(), point(), point()}, {{point()}, {}}}, kRed});
    list.items.emplace_back(DrawDisc{{point(), value()}, kRed});
    list.items.emplace_back(DrawText{point(), std::string("\x1b\xff\n<&>", 6), value(), kRed, kBlue});
    list.items.emplace_back(DrawCells{{value(), value(), value()}, value(), 1, 1, {kRed}, {}});
    list.items.emplace_back(DrawBody{{point(), value()}, value(), kRed, kBlue});
    const Image image = raster(list, {1 + random.below(30), 0});
    ASSERT_EQ(image.pixels.size(), static_cast<std::size_t>(image.width * image.height * 3));
  }
}

TEST(Raster, EqualListsGiveEqualPictures) {
  DrawList list = square(10);
  list.items.emplace_back(DrawText{{2, 2}, "Kitchen", 1.5, kRed, {0, 0, 0, 100}, Align::left});
  list.items.emplace_back(DrawBody{{{5, 5}, 2}, 0.4, kRed, kBlue});
  EXPECT_EQ(raster(list, {120, 0}), raster(list, {120, 0}));
}

TEST(PictureFile, OtherSuffixesAreRefused) {
  try {
    save_picture("map.bmp", square(1));
    FAIL();
  } catch (const ArgumentError& error) {
    EXPECT_STREQ(error.what(), "picture: file name that ends in .svg or .png expected, got 'map.bmp'");
  }
}

}  // namespace
}  // namespace meander
